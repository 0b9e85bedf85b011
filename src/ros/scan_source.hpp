// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>

#include <functional>
#include <map>
#include <string>

#include "adaptive_localization/scan.hpp"
#include "laser_mounts.hpp"

namespace adaptive_localization {

/// Topic 'scan', held back until tf can place each scan in the odometry frame. Counts what came,
/// what was used and what was dropped, and says why.
class ScanSource {
 public:
  /// Says whether the scan was used; throws std::invalid_argument saying what is wrong with it.
  using Callback = std::function<bool(const sensor_msgs::LaserScan&, const LaserMount&)>;

  ScanSource(ros::NodeHandle node, tf2_ros::Buffer& tf, const std::string& odom_frame,
             const std::string& base_frame, Callback callback);

  struct Counts {
    int received{0};
    int used{0};
    int dropped{0};
  };
  const Counts& counts() const { return counts_; }

 private:
  using Filter = tf2_ros::MessageFilter<sensor_msgs::LaserScan>;

  void onMessage(const sensor_msgs::LaserScan::ConstPtr& message);
  void onPlaced(const sensor_msgs::LaserScan::ConstPtr& message);
  void drop(const std::string& why);
  void watch();

  tf2_ros::Buffer& tf_;
  std::string odom_frame_;
  LaserMounts mounts_;
  Callback callback_;
  Counts counts_;
  Counts counts_at_watch_;
  std::string last_frame_;
  std::map<std::string, ros::WallTime> said_;  // reasons for dropping scans
  Filter filter_;
  ros::Subscriber subscriber_;
  ros::WallTimer watchdog_;
};

}  // namespace adaptive_localization
