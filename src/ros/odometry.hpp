// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2_ros/buffer.h>

#include <optional>
#include <string>

#include "adaptive_localization/pose2.hpp"

namespace adaptive_localization {

/// Odometry as tf tells it: T_odom_base.
class Odometry {
 public:
  Odometry(const tf2_ros::Buffer& tf, std::string odom_frame, std::string base_frame);

  /// Nothing, and why, where tf cannot tell. A stamp of zero means the newest.
  std::optional<Pose2> at(const ros::Time& stamp, std::string* why = nullptr) const;

  /// How far the robot went between a stamp and the newest odometry; nothing where tf cannot tell.
  std::optional<Pose2> motionSince(const ros::Time& stamp, std::string* why = nullptr) const;

 private:
  const tf2_ros::Buffer& tf_;
  std::string odom_frame_;
  std::string base_frame_;
};

}  // namespace adaptive_localization
