// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <optional>

#include "adaptive_localization/localizer.hpp"
#include "estimate_publisher.hpp"
#include "map_source.hpp"
#include "node_options.hpp"
#include "odometry.hpp"
#include "pose_keeper.hpp"
#include "scan_source.hpp"

namespace adaptive_localization {

/// The ROS node: amcl's topics, services and parameters around a Localizer. One thread, no locks.
class LocalizationNode {
 public:
  /// Throws std::invalid_argument naming key, value and range when a parameter is wrong.
  LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node);

  /// Keeps the pose for the next start.
  void writePose() const { pose_keeper_.write(); }

 private:
  using Empty = std_srvs::Empty;

  bool onMap(const nav_msgs::OccupancyGrid& message);
  bool onScan(const sensor_msgs::LaserScan& message, const LaserMount& mount);
  void onInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message);
  bool onGlobalLocalization(Empty::Request& request, Empty::Response& response);
  bool onNoMotionUpdate(Empty::Request& request, Empty::Response& response);
  void start(const Prior& prior);

  Parameters parameters_;
  NodeOptions options_;
  std::unique_ptr<Localizer> localizer_;  // once there is a map
  std::optional<Prior> prior_;            // to start from, once there is a map
  double ms_per_update_{0.0};

  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  Odometry odometry_;
  EstimatePublisher publisher_;
  PoseKeeper pose_keeper_;
  ScanSource scans_;
  ros::Subscriber initial_pose_;
  ros::ServiceServer global_localization_;
  ros::ServiceServer no_motion_update_;
  MapSource maps_;
};

}  // namespace adaptive_localization
