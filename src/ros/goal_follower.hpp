// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>

#include <memory>
#include <optional>
#include <string>

#include "sim/way_follower.hpp"
#include "transform_input.hpp"

namespace adaptive_localization {

struct GoalFollowerOptions {
  std::string global_frame_id{"map"};
  std::string base_frame_id{"base_link"};
  double robot_radius{0.28};
  RouteOptions route{0.4, 0.8, 2.0, 0.0, 0.0, 0.05, true};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("global_frame_id", global_frame_id, Choices{}, "Frame of map and goals.");
    option("base_frame_id", base_frame_id, Choices{}, "Frame of the robot.");
    option("robot_radius", robot_radius, Range{0.01, 2}, "m", "Of the disc that must fit through.");
    route.visit(option);
  }
};

/// Stands in for move_base where there is none, to show that a robot can be driven by what
/// localizes it: plans a way through the map to each goal on move_base_simple/goal and follows it
/// by the transform from map to base alone; cmd_vel and the way on topic plan out. It looks at no
/// sensor and avoids nothing that the map does not have. One thread, no locks.
class GoalFollower {
 public:
  /// Throws std::invalid_argument naming what is wrong with a parameter.
  GoalFollower(ros::NodeHandle node, ros::NodeHandle private_node);

  /// Tells a robot that is on its way to stand, and waits until that is sent.
  void stop();

 private:
  GoalFollower(ros::NodeHandle node, const Parameters& parameters);
  void onMap(const nav_msgs::OccupancyGrid& map);
  void onGoal(const geometry_msgs::PoseStamped& goal);
  void advance();
  void command(const Velocity& velocity);
  Velocity approach(const Pose2& T_map_base);
  void publishPlan(const std::vector<Eigen::Vector2d>& way);
  std::optional<Pose2> place() const;  // T_map_base, if tf knows it

  GoalFollowerOptions options_;
  std::shared_ptr<const FreeSpace> free_space_;
  std::optional<WayFollower> follower_;
  std::optional<Pose2> goal_;  // in the map frame
  bool is_there_{false};       // and has to turn yet
  tf2_ros::Buffer tf_;
  TransformInput transforms_;
  ros::Publisher command_, plan_;
  ros::Subscriber maps_, goals_;
  ros::Timer timer_;
};

}  // namespace adaptive_localization
