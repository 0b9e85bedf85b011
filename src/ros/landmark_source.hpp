// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/map/landmark_map.hpp"
#include "complaints.hpp"
#include "laser_mounts.hpp"
#include "node_options.hpp"
#include "odometry.hpp"
#include "sense_health.hpp"
#include "transform_input.hpp"

namespace adaptive_localization {

/// Landmarks as a camera, say, sights them, on the landmark_topic, each message held back until tf
/// can place it in the odometry frame. With a laser they are told with the next scan; a robot
/// without one is localized by them alone.
class LandmarkSource {
 public:
  /// Told when sightings came, with where the robot was.
  using Callback = std::function<void(const ros::Time& stamp, const Pose2& T_odom_base)>;

  /// Throws std::invalid_argument where there is a topic, but no landmark is known.
  LandmarkSource(ros::NodeHandle node, tf2_ros::Buffer& tf, TransformInput& tf_input,
                 const Odometry& odometry, const NodeOptions& options, LandmarkMap known,
                 Callback callback);

  /// Adds what was sighted last, as seen from where the robot is by now, and forgets it.
  void observe(const Pose2& T_odom_base, Observations& observations);

  const LandmarkMap& known() const { return known_; }

  void forget();

  /// Nothing without a landmark_topic.
  std::optional<SenseHealth> health() const;

 private:
  struct Picture {
    ros::Time stamp;
    Pose2 T_odom_base;
    std::vector<Sighting> sightings;
  };

  void add(const sensor_msgs::PointCloud::ConstPtr& message);
  void use(const sensor_msgs::PointCloud& message);
  void drop(const std::string& why);
  bool isKnown(const Sighting& sighting) const;

  TransformInput& tf_input_;
  const Odometry& odometry_;
  const NodeOptions& options_;  // the node's, which may change
  LandmarkMap known_;
  Callback callback_;
  LaserMounts mounts_;
  Complaints complaints_;
  Heard heard_;  // messages
  ros::Time last_;
  std::optional<Picture> picture_;
  tf2_ros::MessageFilter<sensor_msgs::PointCloud> filter_;
  ros::Subscriber subscriber_;
};

}  // namespace adaptive_localization
