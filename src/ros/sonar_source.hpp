// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <tf2_ros/buffer.h>

#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "../bag/sonar_ear.hpp"
#include "complaints.hpp"
#include "laser_mounts.hpp"
#include "node_options.hpp"
#include "odometry.hpp"
#include "sense_health.hpp"

namespace adaptive_localization {

/// Sonars on the sonar_topics. What they heard waits until tf can place it in the odometry frame.
/// With a laser it is told with the next scan; a robot without one is localized by it, ten times a
/// second.
class SonarSource {
 public:
  /// Told when there is something new, with where the robot was.
  using Callback = std::function<void(const ros::Time& stamp, const Pose2& T_odom_base)>;

  /// Told a stamp that is of another time, so many seconds, below 0, after the last one; has to
  /// call forget() if it is believed.
  using JumpCallback = std::function<void(const ros::Time& stamp, double seconds)>;

  /// The options are the node's, which may change.
  SonarSource(ros::NodeHandle node, tf2_ros::Buffer& tf, const Odometry& odometry,
              const NodeOptions& options, Callback callback, JumpCallback on_jump);

  /// Adds what was heard by the stamp of the observations, from where the robot is by now, and
  /// forgets it.
  void observe(const Pose2& T_odom_base, Observations& observations);

  /// As if it had come on its topic, if that is one of these.
  void add(const BagMessage& message);

  void forget();

  /// Nothing without sonar_topics.
  std::optional<SenseHealth> health() const;

 private:
  struct Placed {
    Pose2 T_odom_base;
    SonarRound round;
  };

  void place();
  void tell();
  void drop(const std::string& why);
  void complain(const std::string& why);

  const Odometry& odometry_;
  Callback callback_;
  JumpCallback on_jump_;
  LaserMounts mounts_;
  Complaints complaints_;
  SonarEar ear_;
  std::deque<SonarRound> waiting_;
  std::deque<Placed> placed_;
  double last_{std::numeric_limits<double>::quiet_NaN()};  // stamp of those that were placed,
  double told_{0.0};                                       // and of those that were told of, s
  int dropped_{0};                                         // messages that tf could not place
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace adaptive_localization
