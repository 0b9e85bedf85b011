// SPDX-License-Identifier: BSD-3-Clause
#include "pose_keeper.hpp"

#include <ros/console.h>
#include <ros/master.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "pose_file.hpp"

namespace adaptive_localization {

PoseKeeper::PoseKeeper(const ros::NodeHandle& private_node, double rate, std::string file)
    : node_(private_node), rate_(rate), file_(std::move(file)) {}

void PoseKeeper::keep(const Gaussian2& pose, const ros::Time& stamp) {
  if (rate_ <= 0.0 || !isFinite(pose.mean) || !pose.covariance.allFinite()) return;
  pose_ = pose;
  // Its absolute value, so that writing goes on when time jumped back.
  if (std::abs(stamp.toSec() - written_.toSec()) < 1.0 / rate_) return;
  written_ = stamp;
  write();
}

void PoseKeeper::write() const {
  if (!pose_) return;
  writeFile();
  if (!ros::master::check()) {  // setParam would wait for it, and with it the whole node
    ROS_WARN_THROTTLE(10.0, "No ROS master at %s: localizing goes on, but the pose is not kept",
                      ros::master::getURI().c_str());
    return;
  }
  node_.setParam("initial_pose_x", pose_->mean.x);
  node_.setParam("initial_pose_y", pose_->mean.y);
  node_.setParam("initial_pose_a", pose_->mean.theta);
  node_.setParam("initial_cov_xx", pose_->covariance(0, 0));
  node_.setParam("initial_cov_yy", pose_->covariance(1, 1));
  node_.setParam("initial_cov_aa", pose_->covariance(2, 2));
}

void PoseKeeper::writeFile() const {
  if (file_.empty()) return;
  try {
    writePoseFile(file_, *pose_);
  } catch (const std::runtime_error& error) {
    ROS_WARN_THROTTLE(60.0, "Pose not kept: %s", error.what());
  }
}

}  // namespace adaptive_localization
