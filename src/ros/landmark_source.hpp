// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "../bag/bag_stream.hpp"
#include "../bag/sighting_ear.hpp"
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

  /// Told a stamp that is of another time, so many seconds, below 0, after the last one; has to
  /// call forget() if it is believed.
  using JumpCallback = std::function<void(const ros::Time& stamp, double seconds)>;

  /// Throws std::invalid_argument where there is a topic, but no landmark is known.
  LandmarkSource(ros::NodeHandle node, tf2_ros::Buffer& tf, TransformInput& tf_input,
                 const Odometry& odometry, const NodeOptions& options, LandmarkMap known,
                 Callback callback, JumpCallback on_jump);

  /// The same from a bag, if it is of the landmark_topic.
  void add(const BagMessage& message);

  /// Adds what each camera sighted last, as seen from where the robot is by now, and forgets it.
  void observe(const Pose2& T_odom_base, Observations& observations);

  const LandmarkMap& known() const { return ear_.known(); }

  void forget();

  /// Nothing without a landmark_topic.
  std::optional<SenseHealth> health() const;

 private:
  struct Placed {
    Pose2 T_odom_base;
    Picture picture;
  };

  void add(const sensor_msgs::PointCloud::ConstPtr& message);
  void use(const sensor_msgs::PointCloud& message);
  void checkTime(const ros::Time& stamp);

  TransformInput& tf_input_;
  const Odometry& odometry_;
  const NodeOptions& options_;  // the node's, which may change
  Callback callback_;
  JumpCallback on_jump_;
  LaserMounts mounts_;
  Complaints complaints_;
  SightingEar ear_;
  std::map<std::string, Placed> newest_;  // by frame
  tf2_ros::MessageFilter<sensor_msgs::PointCloud> filter_;
  ros::Subscriber subscriber_;
};

}  // namespace adaptive_localization
