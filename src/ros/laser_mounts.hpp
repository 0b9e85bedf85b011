// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>

#include "adaptive_localization/core/scan.hpp"
#include "core/background.hpp"

namespace adaptive_localization {

/// Where the lasers, or sensors of another kind, sit on the robot. tf says so; for a frame that tf
/// does not know, the URDF in robot_description does, through its fixed joints. Says once per laser
/// which of the two it was. The angles between which a laser sees come from robot_description, if
/// it has them.
class LaserMounts {
 public:
  /// `kind` is what messages call them.
  LaserMounts(const ros::NodeHandle& node, tf2_ros::Buffer& tf, std::string base_frame,
              std::string kind = "Laser");

  enum class Knowledge { kKnown, kNotYet, kUnknown };

  /// Whether tf can place this frame on the robot. Once tf has failed to for a second, a mount
  /// found in robot_description is put into this node's tf buffer, so that all lookups succeed.
  Knowledge lookFor(const std::string& frame);

  /// Where a sensor of another kind sits, T_base_sensor. Throws std::exception, saying why, if
  /// nobody knows.
  Eigen::Isometry3d placeOf(const std::string& frame);

  /// The mount at a stamp, so that a laser may move. Nothing, and why, where tf cannot tell.
  std::optional<LaserMount> at(const std::string& frame, const ros::Time& stamp,
                               std::string* why) const;

 private:
  struct Laser {
    ros::WallTime first_seen;
    bool known{false};
    bool urdf_asked{false};  // again, for this laser
    bool urdf_tried{false};
    AngleLimits view;  // of robot_description
  };

  bool askAgain(Laser& laser);
  bool takeFromUrdf(const std::string& frame);
  void know(const std::string& frame, Laser& laser, const char* source);
  void say(const std::string& frame, const char* source) const;

  ros::NodeHandle node_;
  tf2_ros::Buffer& tf_;
  std::string base_frame_;
  std::string kind_;
  std::map<std::string, Laser> lasers_;
  std::string robot_description_;
  Background<std::string> asking_;  // for the same, if a laser is not in it
};

}  // namespace adaptive_localization
