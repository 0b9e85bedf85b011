// SPDX-License-Identifier: BSD-3-Clause
#include "odometry.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "adaptive_localization/core/options.hpp"
#include "conversions.hpp"

namespace adaptive_localization {

Odometry::Odometry(const tf2_ros::Buffer& tf, std::string odom_frame, std::string base_frame)
    : tf_(tf), odom_frame_(std::move(odom_frame)), base_frame_(std::move(base_frame)) {}

std::optional<Pose2> Odometry::at(const ros::Time& stamp, std::string* why) const {
  try {
    const Pose2 pose = toPose2(tf_.lookupTransform(odom_frame_, base_frame_, stamp).transform);
    checkPlace(base_frame_, odom_frame_, pose.x, pose.y, kFarthest);
    if (isFinite(pose)) return pose;
    if (why) *why = "the transform from " + base_frame_ + " to " + odom_frame_ + " is not finite";
  } catch (const std::runtime_error& error) {  // of tf2, or of a stamp near the end of time
    if (why) *why = error.what();
  }
  return std::nullopt;
}

std::optional<ros::Time> Odometry::newest() const {
  try {
    return tf_.lookupTransform(odom_frame_, base_frame_, ros::Time(0)).header.stamp;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

std::optional<Pose2> Odometry::motionSince(const ros::Time& stamp, std::string* why) const {
  const auto then = at(stamp, why);
  const auto now = at(ros::Time(0), why);
  if (!then || !now) return std::nullopt;
  return between(*then, *now);
}

BaseVelocity Odometry::velocityDuring(const ros::Time& stamp, double seconds) const {
  constexpr double kShortest = 0.02;  // s; tf's stamps and poses are too coarse for less
  const double span = std::max(seconds, kShortest);
  const auto now = at(stamp);
  const auto later = at(stamp + ros::Duration(span));
  const auto before =
      later || stamp.toSec() < span ? std::nullopt : at(stamp - ros::Duration(span));
  if (!now || !(later || before)) return {};
  const Pose2 motion = later ? between(*now, *later) : between(*before, *now);
  return {motion.x / span, motion.y / span, motion.theta / span};
}

}  // namespace adaptive_localization
