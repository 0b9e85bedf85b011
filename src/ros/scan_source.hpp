// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>

#include <functional>
#include <string>
#include <vector>

#include "adaptive_localization/core/scan.hpp"
#include "arrival_queue.hpp"
#include "complaints.hpp"
#include "continuity.hpp"
#include "laser_mounts.hpp"
#include "node_options.hpp"
#include "transform_input.hpp"

namespace adaptive_localization {

/// Scans of one laser or several, each held back until tf can place it in the odometry frame.
/// Counts what came, what was used and what was dropped, and says why. When time jumps back, tf is
/// emptied and what was held back is forgotten.
class ScanSource {
 public:
  /// Given a scan, its mount and when it arrived, says whether the scan was used; throws what is
  /// wrong with it.
  using Callback =
      std::function<bool(const sensor_msgs::LaserScan&, const LaserMount&, const ros::SteadyTime&)>;
  /// Told by how many seconds time jumped.
  using JumpCallback = std::function<void(double)>;

  ScanSource(ros::NodeHandle node, tf2_ros::Buffer& tf, TransformInput& tf_input,
             const NodeOptions& options, Callback callback, JumpCallback on_jump);

  /// Whether the robot has a laser at all.
  bool hasTopics() const { return !subscribers_.empty(); }

  /// Whether this is one of its topics, given without the slash in front.
  bool hears(const std::string& topic) const;

  /// As if it had come on a topic.
  void add(const sensor_msgs::LaserScan::ConstPtr& message);

  struct Counts {
    int received{0};
    int used{0};
    int dropped{0};
  };
  const Counts& counts() const { return counts_; }

  /// Says in the log, now and then, what is strange about a scan that is used all the same.
  void complain(const std::string& why);

  /// What is missing for scans to get through: any scan at all, which transform, or one that is not
  /// refused. Empty as long as they do.
  std::string missing() const;

 private:
  using Filter = tf2_ros::MessageFilter<sensor_msgs::LaserScan>;
  using Event = ros::MessageEvent<const sensor_msgs::LaserScan>;

  void onJump(double seconds, const ros::Time& stamp);
  bool use(const Event& event);
  bool isSettled() const;
  void drop(const std::string& why, bool is_said = true);

  tf2_ros::Buffer& tf_;
  TransformInput& tf_input_;    // which fills it
  const NodeOptions& options_;  // the node's, which may change
  LaserMounts mounts_;
  Callback callback_;
  JumpCallback on_jump_;
  StampWatch stamps_;
  Counts counts_;
  ros::WallTime first_received_;
  ros::WallTime last_received_;
  ros::WallTime last_read_;
  std::string last_frame_;
  std::string why_dropped_;  // the last one, if none was read since
  Complaints complaints_;    // of scans
  Filter filter_;
  ArrivalQueue arrivals_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace adaptive_localization
