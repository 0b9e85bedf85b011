// SPDX-License-Identifier: BSD-3-Clause
#include "pose_keeper.hpp"

#include <ros/console.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "pose_file.hpp"

namespace adaptive_localization {

PoseKeeper::PoseKeeper(ParameterWriter& parameters, double rate, std::string file)
    : parameters_(parameters), rate_(rate), file_(std::move(file)) {}

void PoseKeeper::setRate(double rate) {
  rate_ = rate;
  if (rate_ <= 0.0) pose_.reset();
}

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
  parameters_.set("initial_pose_x", pose_->mean.x);
  parameters_.set("initial_pose_y", pose_->mean.y);
  parameters_.set("initial_pose_a", pose_->mean.theta);
  parameters_.set("initial_cov_xx", pose_->covariance(0, 0));
  parameters_.set("initial_cov_yy", pose_->covariance(1, 1));
  parameters_.set("initial_cov_aa", pose_->covariance(2, 2));
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
