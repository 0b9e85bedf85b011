// SPDX-License-Identifier: BSD-3-Clause
// How the node starts anew: where time or odometry jumps, and where it is told to.
#include <utility>

#include "initial_pose.hpp"
#include "localization_node.hpp"

namespace adaptive_localization {

/// Forward, odometry bridges the gap; back, it has started anew as well.
void LocalizationNode::onTimeJump(double seconds) {
  if (seconds > 0.0) {
    ROS_WARN("No scan for %.1f s, or time jumped: going on with the odometry", seconds);
    if (localizer_) localizer_->requestUpdate();
    return;
  }
  ROS_WARN("Time jumped back by %.1f s: starting anew around the last pose", -seconds);
  odometry_watch_.forget();
  headings_.forget();
  landmarks_.forget();
  sonars_.forget();
  last_scan_ = {};
  publisher_.forgetStamps();
  if (answer_) startAround(*answer_);
}

/// Scans tell the time where there are any. A stamp alone may be nonsense: odometry must be of that
/// time, too.
void LocalizationNode::onOtherTimeJump(const ros::Time& stamp, double seconds) {
  if (scans_.hasTopics()) return;
  const auto newest = odometry_.newest();
  if (newest && newest->toSec() < stamp.toSec() + kTimeBack) onTimeJump(seconds);
}

/// The robot may have been moved while time or odometry jumped, but most likely it was not.
void LocalizationNode::startAround(const Localization& known) {
  constexpr int kTrial = 20;
  if (known.status == Status::kUninitialised) return;
  if (known.status == Status::kGlobalizing && is_anywhere_) return start(Anywhere{});
  const Eigen::Matrix3d wider = known.covariance + options_.initialPose().covariance;
  start(Gaussian2{known.T_map_base, wider});
  updates_on_trial_ = kTrial;
}

/// Asks for updates though the robot may stand still: one more after a start, if the options say
/// so, and after a jump until it is clear whether the robot is where it was.
void LocalizationNode::requestFollowUps() {
  if (answer_->updated && std::exchange(update_again_, false)) localizer_->requestUpdate();
  if (updates_on_trial_ == 0) return;
  if (answer_->status == Status::kTracking) {
    updates_on_trial_ = 0;
  } else if (--updates_on_trial_ > 0) {
    localizer_->requestUpdate();
  } else {
    ROS_WARN("The robot is not where it was before the jump: localizing anywhere on the map");
    start(Anywhere{});
  }
}

void LocalizationNode::onInitialPose(const PoseWithCovarianceStamped& message) {
  const auto pose = readInitialPose(message, options_.global_frame_id, odometry_);
  if (!pose) return;
  start(*pose);
  update_again_ = options_.force_update_after_initialpose;
}

bool LocalizationNode::onSetMap(nav_msgs::SetMap::Request& request,
                                nav_msgs::SetMap::Response& response) {
  const auto pose = readInitialPose(request.initial_pose, options_.global_frame_id, odometry_);
  response.success = pose && map_builder_.build(std::move(request.map), true);
  if (!response.success) return true;
  maps_.stopAsking();
  start(*pose);
  update_again_ = options_.force_update_after_set_map;
  return true;
}

bool LocalizationNode::onGlobalLocalization() {
  ROS_INFO("Localizing anywhere on the map");
  start(Anywhere{});
  return true;
}

bool LocalizationNode::onNoMotionUpdate() {
  if (localizer_) localizer_->requestUpdate();
  return true;
}

void LocalizationNode::start(const Prior& prior) {
  updates_on_trial_ = 0;
  update_again_ = false;
  is_anywhere_ = std::holds_alternative<Anywhere>(prior);
  if (localizer_) {
    localizer_->reset(prior);
  } else {
    prior_ = prior;
  }
}

}  // namespace adaptive_localization
