// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

inline geometry_msgs::Quaternion yaw(double theta) {
  geometry_msgs::Quaternion q;
  q.z = std::sin(theta / 2);
  q.w = std::cos(theta / 2);
  return q;
}

/// Writes small bags for tests; each message is recorded at its own stamp unless told otherwise.
class BagWriter {
 public:
  explicit BagWriter(const std::string& file, rosbag::compression::CompressionType compression =
                                                  rosbag::compression::Uncompressed)
      : bag_(file, rosbag::bagmode::Write) {
    bag_.setCompression(compression);
  }

  void transform(const std::string& topic, double stamp, const std::string& parent,
                 const std::string& child, double x, double y,
                 const geometry_msgs::Quaternion& rotation, double recorded_at = -1.0) {
    tf2_msgs::TFMessage message;
    message.transforms.resize(1);
    auto& transform = message.transforms[0];
    transform.header.stamp = ros::Time(stamp);
    transform.header.frame_id = parent;
    transform.child_frame_id = child;
    transform.transform.translation.x = x;
    transform.transform.translation.y = y;
    transform.transform.rotation = rotation;
    bag_.write(topic, ros::Time(recorded_at < 0.0 ? stamp : recorded_at), message);
  }

  void odometryTransform(double stamp, const Pose2& pose) {
    transform("/tf", stamp, "odom", "base_link", pose.x, pose.y, yaw(pose.theta));
  }

  void laserTransform(double stamp, const std::string& topic = "/tf_static") {
    transform(topic, stamp, "base_link", "laser", 0.2, 0.1, yaw(0.0));
  }

  void odometry(const std::string& topic, double stamp, const Pose2& pose) {
    nav_msgs::Odometry message;
    message.header.stamp = ros::Time(stamp);
    message.header.frame_id = "odom";
    message.child_frame_id = "base_link";
    message.pose.pose.position.x = pose.x;
    message.pose.pose.position.y = pose.y;
    message.pose.pose.orientation = yaw(pose.theta);
    bag_.write(topic, recordingTime(stamp), message);
  }

  void pose(const std::string& topic, double stamp, const Pose2& pose) {
    geometry_msgs::PoseStamped message;
    message.header.stamp = ros::Time(stamp);
    message.pose.position.x = pose.x;
    message.pose.position.y = pose.y;
    message.pose.orientation = yaw(pose.theta);
    bag_.write(topic, recordingTime(stamp), message);
  }

  void scan(const std::string& topic, double stamp, std::size_t beams = 5,
            const std::string& frame = "laser") {
    sensor_msgs::LaserScan message;
    message.header.stamp = ros::Time(stamp);
    message.header.frame_id = frame;
    message.angle_min = -1.0F;
    message.angle_increment = 2.0F / static_cast<float>(beams - 1);
    message.angle_max = 1.0F;
    message.range_min = 0.1F;
    message.range_max = 8.0F;
    message.ranges.assign(beams, 2.0F);
    bag_.write(topic, recordingTime(stamp), message);
  }

  template <class Message>
  void write(const std::string& topic, double recorded_at, const Message& message) {
    bag_.write(topic, ros::Time(recorded_at), message);
  }

 private:
  static ros::Time recordingTime(double stamp) {
    return std::max(ros::Time(stamp), ros::TIME_MIN);  // earlier ones rosbag refuses
  }

  rosbag::Bag bag_;  // closes the file with itself
};

}  // namespace adaptive_localization
