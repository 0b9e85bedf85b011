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
#include "sense_health.hpp"

namespace adaptive_localization {

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
  std::string topics() const;

  const Odometry& odometry_;
  const NodeOptions& options_;  // the node's, which may change
  LaserMounts mounts_;
  Complaints complaints_;
  HeadingEar ear_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace adaptive_localization
