// SPDX-License-Identifier: BSD-3-Clause
#include "odometry.hpp"

#include <utility>

#include "conversions.hpp"

namespace adaptive_localization {

Odometry::Odometry(const tf2_ros::Buffer& tf, std::string odom_frame, std::string base_frame)
    : tf_(tf), odom_frame_(std::move(odom_frame)), base_frame_(std::move(base_frame)) {}

std::optional<Pose2> Odometry::at(const ros::Time& stamp, std::string* why) const {
  try {
    const Pose2 pose = toPose2(tf_.lookupTransform(odom_frame_, base_frame_, stamp).transform);
    if (isFinite(pose)) return pose;
    if (why) *why = "the transform from " + base_frame_ + " to " + odom_frame_ + " is not finite";
  } catch (const tf2::TransformException& error) {
    if (why) *why = error.what();
  }
  return std::nullopt;
}

std::optional<Pose2> Odometry::motionSince(const ros::Time& stamp, std::string* why) const {
  const auto then = at(stamp, why);
  const auto now = at(ros::Time(0), why);
  if (!then || !now) return std::nullopt;
  return between(*then, *now);
}

}  // namespace adaptive_localization
