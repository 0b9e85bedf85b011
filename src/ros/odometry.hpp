// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2_ros/buffer.h>

#include <optional>
#include <string>

#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Odometry as tf tells it: T_odom_base.
class Odometry {
 public:
  Odometry(const tf2_ros::Buffer& tf, std::string odom_frame, std::string base_frame);

  /// Nothing, and why, where tf cannot tell. A stamp of zero means the newest.
  std::optional<Pose2> at(const ros::Time& stamp, std::string* why = nullptr) const;

  /// The stamp of the newest odometry; nothing where tf cannot tell.
  std::optional<ros::Time> newest() const;

  /// How far the robot went between a stamp and the newest odometry; nothing where tf cannot tell.
  std::optional<Pose2> motionSince(const ros::Time& stamp, std::string* why = nullptr) const;

  /// How the robot moves during the seconds after a stamp; where tf does not know their end yet, as
  /// in the same time before it. Zero where tf cannot tell.
  BaseVelocity velocityDuring(const ros::Time& stamp, double seconds) const;

 private:
  const tf2_ros::Buffer& tf_;
  std::string odom_frame_;
  std::string base_frame_;
};

}  // namespace adaptive_localization
