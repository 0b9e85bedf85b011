// SPDX-License-Identifier: BSD-3-Clause
#include "estimate_publisher.hpp"

#include <algorithm>
#include <utility>

#include "callbacks.hpp"
#include "conversions.hpp"
#include "status_message.hpp"

namespace adaptive_localization {
namespace {

using diagnostic_msgs::DiagnosticStatus;

DiagnosticStatus::_level_type levelOf(Status status) {
  if (status == Status::kTracking) return DiagnosticStatus::OK;
  return status == Status::kLost ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN;
}

constexpr std::size_t kModesInStatus = 5;
constexpr std::size_t kModesSent = 100;

}  // namespace

EstimatePublisher::EstimatePublisher(ros::NodeHandle node, ros::NodeHandle private_node,
                                     const NodeOptions& options)
    : options_(options),
      pose_topic_(node, "amcl_pose", [this] { return pose(); }),
      cloud_topic_(node, "particlecloud", [this] { return cloud(); }),
      modes_topic_(private_node, "modes", [this] { return modes(); }),
      leaders_topic_(private_node, "leaders", [this] { return leaders(); }),
      confidence_topic_(private_node, "confidence", [this] { return confidence(); }),
      status_topic_(private_node, "status", [this] { return status(); }) {
  if (options.tf_rate <= 0.0) return;
  timer_ = every(node, ros::Duration(1.0 / options.tf_rate), "Transform", [this] {
    if (options_.tf_broadcast && T_map_odom_) sendTransform(*T_map_odom_, ros::Time::now());
  });
}

void EstimatePublisher::publish(const Localization& answer, const Particles& particles,
                                const ros::Time& stamp,
                                const std::optional<ros::SteadyTime>& scan_arrival) {
  if (answer.updated) {
    update_.stamp = stamp;
    update_.made = ros::Time::now();
    update_.answer = answer;
    update_.particles = particles;
    pose_topic_.publish();
    cloud_topic_.publish();
    modes_topic_.publish();
  }
  T_map_odom_ = answer.T_map_odom;
  unsent_.reset();
  if (scan_arrival) unsent_ = ScanTimes{stamp, *scan_arrival};
  if (options_.tf_broadcast && options_.tf_rate <= 0.0) sendTransform(answer.T_map_odom, stamp);
  confidence_ = answer.confidence;
  confidence_topic_.publish();
}

void EstimatePublisher::publishLeaders(const Particles& leaders, const ros::Time& stamp) {
  if (leaders.size() == 0 && leaders_.size() == 0) return;
  leaders_ = leaders;
  leaders_stamp_ = stamp;
  leaders_topic_.publish();
}

void EstimatePublisher::publishStatus(const Localization& answer, const Figures& figures) {
  answer_ = answer;
  figures_ = figures;
  status_topic_.publish();
}

void EstimatePublisher::sendTransform(const Pose2& T_map_odom, const ros::Time& stamp) {
  if (stamp <= sent_) return;  // tf complains about a stamp given twice; two lasers may share one
  sent_ = stamp;
  geometry_msgs::TransformStamped transform;
  transform.header = headerAt(stamp + ros::Duration(options_.transform_tolerance));
  transform.child_frame_id = options_.odom_frame_id;
  transform.transform = toTransformMessage(T_map_odom);
  broadcaster_.sendTransform(transform);
  const auto scan = std::exchange(unsent_, std::nullopt);
  if (!scan) return;
  const ros::SteadyTime now = ros::SteadyTime::now();
  latency_.add(now.toSec(), ros::Time::now().toSec() - scan->stamp.toSec(),
               (now - scan->arrival).toSec());
}

Latency::Minute EstimatePublisher::latency() const {
  return latency_.lastMinute(ros::SteadyTime::now().toSec());
}

std_msgs::Header EstimatePublisher::headerAt(const ros::Time& stamp) const {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = options_.global_frame_id;
  return header;
}

geometry_msgs::PoseWithCovarianceStamped EstimatePublisher::pose() const {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header = headerAt(update_.stamp);
  message.pose = toMessage(update_.answer.T_map_base, update_.answer.covariance);
  return message;
}

geometry_msgs::PoseArray EstimatePublisher::cloud() const {
  geometry_msgs::PoseArray message = toMessage(update_.particles);
  message.header = headerAt(update_.made);
  return message;
}

/// Heaviest first; their masses are in the status.
geometry_msgs::PoseArray EstimatePublisher::modes() const {
  geometry_msgs::PoseArray message;
  message.header = headerAt(update_.stamp);
  const auto& modes = update_.answer.modes;
  for (std::size_t i = 0; i < std::min(modes.size(), kModesSent); ++i) {
    message.poses.push_back(toPoseMessage(modes[i].T_map_base));
  }
  return message;
}

geometry_msgs::PoseArray EstimatePublisher::leaders() const {
  geometry_msgs::PoseArray message = toMessage(leaders_);
  message.header = headerAt(leaders_stamp_);
  return message;
}

std_msgs::Float32 EstimatePublisher::confidence() const {
  std_msgs::Float32 message;
  message.data = static_cast<float>(confidence_);
  return message;
}

DiagnosticStatus EstimatePublisher::status() const {
  DiagnosticStatus status =
      makeStatus("localization", levelOf(answer_.status), toText(answer_.status));
  add(status, "stamp", print("%u.%09u", figures_.stamp.sec, figures_.stamp.nsec));
  add(status, "updated", answer_.updated ? "yes" : "no");
  add(status, "confidence", print("%.3f", answer_.confidence));
  const auto& modes = answer_.modes;
  add(status, "modes", std::to_string(modes.size()));
  for (std::size_t i = 0; i < std::min(modes.size(), kModesInStatus); ++i) {
    const Pose2& pose = modes[i].T_map_base;
    add(status, "mode " + std::to_string(i + 1),
        print("mass %.3f at x %.3f m, y %.3f m, yaw %.1f deg", modes[i].mass, pose.x, pose.y,
              pose.theta * 180.0 / kPi));
  }
  if (figures_.match) {
    const bool is_good = *figures_.match == MatchFault::kNone;
    add(status, "match", is_good ? "used" : toText(*figures_.match));
    add(status, "match inliers", print("%.3f", figures_.match_inliers));
  }
  add(status, "particles", std::to_string(figures_.particles));
  add(status, "ms per update", print("%.3f", figures_.ms_per_update));
  addCounts(status, figures_.scans);
  addSenses(status, figures_.senses);
  return status;
}

}  // namespace adaptive_localization
