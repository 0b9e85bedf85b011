// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <tf2_ros/buffer.h>

#include <string>
#include <vector>

#include "../bag/heading_ear.hpp"
#include "complaints.hpp"
#include "laser_mounts.hpp"
#include "node_options.hpp"
#include "odometry.hpp"

namespace adaptive_localization {

/// How a sense beside the laser is heard, for a reader.
struct SenseHealth {
  std::string name;
  Heard heard;
  std::string missing;  // "nothing heard on /imu", "silent for 3 s"; empty while it is heard
};

/// The same with what becomes of it.
struct SenseStatus {
  SenseHealth health;
  std::string state;  // "used", "disturbed", "silent for 3 s"
  bool is_fine{true};
};

/// A compass and a gyroscope, on the topics that the options name.
class HeadingSource {
 public:
  HeadingSource(ros::NodeHandle node, tf2_ros::Buffer& tf, const Odometry& odometry,
                const NodeOptions& options);

  /// Adds what was heard by the stamp of the observations, where the robot is at T_odom_base. A
  /// heading of a moment ago is turned on with the odometry.
  void observe(const Pose2& T_odom_base, Observations& observations) const;

  /// As if it had come on its topic, if that is one of these.
  void add(const BagMessage& message) { ear_.hear(message); }

  /// Time jumped back: what was heard is of another time.
  void forget() { ear_.history().clear(); }

  /// Of those that the options name topics for.
  std::vector<SenseHealth> health() const;

 private:
  template <class Message>
  void listen(ros::NodeHandle& node, const std::string& topic);
  Eigen::Matrix3d rotationOf(const std::string& frame);
  SenseHealth healthOf(const std::string& name, const Heard& heard, double last) const;

  tf2_ros::Buffer& tf_;
  const Odometry& odometry_;
  const NodeOptions& options_;  // the node's, which may change
  LaserMounts mounts_;
  Complaints complaints_;
  HeadingEar ear_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace adaptive_localization
