// SPDX-License-Identifier: BSD-3-Clause
#include "laser_mounts.hpp"

#include <ros/console.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "conversions.hpp"
#include "urdf_mount.hpp"

namespace adaptive_localization {
namespace {

constexpr double kMostReach = 100.0;  // m, of a robot

std::string readDescription(const ros::NodeHandle& node) {
  std::string key, urdf;
  if (node.searchParam("robot_description", key)) node.getParam(key, urdf);
  return urdf;
}

}  // namespace

LaserMounts::LaserMounts(const ros::NodeHandle& node, tf2_ros::Buffer& tf, std::string base_frame,
                         std::string kind)
    : node_(node),
      tf_(tf),
      base_frame_(std::move(base_frame)),
      kind_(std::move(kind)),
      robot_description_(readDescription(node)) {}

LaserMounts::Knowledge LaserMounts::lookFor(const std::string& frame) {
  Laser& laser = lasers_[frame];
  if (laser.known) return Knowledge::kKnown;
  if (laser.first_seen.isZero()) laser.first_seen = ros::WallTime::now();
  if (tf_.canTransform(base_frame_, frame, ros::Time(0))) {
    know(frame, laser, "tf");
    return Knowledge::kKnown;
  }
  // tf's latched static transforms may still be on their way.
  if (ros::WallTime::now() - laser.first_seen < ros::WallDuration(1.0)) return Knowledge::kNotYet;
  if (askAgain(laser)) return Knowledge::kNotYet;
  if (!std::exchange(laser.urdf_tried, true) && takeFromUrdf(frame)) {
    know(frame, laser, "robot_description, as tf does not have it");
    return Knowledge::kKnown;
  }
  return Knowledge::kUnknown;
}

Eigen::Isometry3d LaserMounts::placeOf(const std::string& frame) {
  if (lookFor(frame) != Knowledge::kKnown) {
    throw std::invalid_argument("neither tf nor robot_description knows where frame '" + frame +
                                "' is");
  }
  return toIsometry(tf_.lookupTransform(base_frame_, frame, ros::Time(0)).transform);
}

/// The description may have come after this node. A master that does not answer must not hold up
/// the scans: true while its answer is awaited.
bool LaserMounts::askAgain(Laser& laser) {
  if (const auto answer = asking_.poll(); answer && !answer->value.value_or("").empty()) {
    robot_description_ = *answer->value;
  }
  if (asking_.isRunning()) return true;
  if (std::exchange(laser.urdf_asked, true)) return false;
  asking_.start([node = node_](const StopToken&) { return readDescription(node); });
  return true;
}

void LaserMounts::know(const std::string& frame, Laser& laser, const char* source) {
  laser.known = true;
  say(frame, source);
  laser.view = viewFromUrdf(robot_description_, frame);
  if (std::isfinite(laser.view.low)) {
    ROS_INFO("%s '%s' sees from %.1f to %.1f deg: from robot_description", kind_.c_str(),
             frame.c_str(), laser.view.low * 180.0 / kPi, laser.view.high * 180.0 / kPi);
  }
}

bool LaserMounts::takeFromUrdf(const std::string& frame) {
  if (robot_description_.empty()) return false;
  geometry_msgs::TransformStamped transform;
  try {
    transform.transform = toTransformMessage(mountFromUrdf(robot_description_, base_frame_, frame));
  } catch (const std::invalid_argument& error) {
    ROS_WARN("No mount for '%s': %s", frame.c_str(), error.what());
    return false;
  }
  transform.header.frame_id = base_frame_;
  transform.child_frame_id = frame;
  return tf_.setTransform(transform, "robot_description", true);
}

void LaserMounts::say(const std::string& frame, const char* source) const {
  std::string why;
  if (const auto mount = at(frame, ros::Time(0), &why)) {
    ROS_INFO("%s '%s' sits at (%.3f, %.3f) m, %.1f deg on '%s': from %s", kind_.c_str(),
             frame.c_str(), mount->position.x(), mount->position.y(),
             std::atan2(mount->axes(1, 0), mount->axes(0, 0)) * 180.0 / kPi, base_frame_.c_str(),
             source);
  }
}

std::optional<LaserMount> LaserMounts::at(const std::string& frame, const ros::Time& stamp,
                                          std::string* why) const {
  try {
    const bool then = tf_.canTransform(base_frame_, frame, stamp);
    LaserMount mount =
        toMount(tf_.lookupTransform(base_frame_, frame, then ? stamp : ros::Time(0)).transform);
    checkPlace(frame, base_frame_, mount.position.x(), mount.position.y(), kMostReach);
    const auto laser = lasers_.find(frame);
    if (laser != lasers_.end()) mount.view = laser->second.view;
    return mount;
  } catch (const std::runtime_error& error) {  // of tf2, or of a stamp near the end of time
    *why = error.what();
    return std::nullopt;
  }
}

}  // namespace adaptive_localization
