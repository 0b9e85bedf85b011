// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <tf2_ros/transform_broadcaster.h>

#include <optional>
#include <vector>

#include "adaptive_localization/localizer/localizer.hpp"
#include "heading_source.hpp"
#include "node_options.hpp"
#include "scan_source.hpp"

namespace adaptive_localization {

/// What the node tells the world: amcl_pose, particlecloud, map -> odom, ~modes, ~leaders,
/// ~confidence and ~status.
class EstimatePublisher {
 public:
  EstimatePublisher(ros::NodeHandle node, ros::NodeHandle private_node, const NodeOptions& options);

  /// After a scan was used. The transform goes out every time (or at its own
  /// rate), pose, cloud and modes only after an update.
  void publish(const Localization& answer, const Particles& particles, const ros::Time& stamp);

  /// The leaders of a swarm; none, once, when a filter has no more: the topic is latched.
  void publishLeaders(const Particles& leaders, const ros::Time& stamp);

  /// The status in words with its figures, after the scan of this stamp. `ms_per_update` is that
  /// of the last update, and so is the match, if there is one.
  void publishStatus(const Localization& answer, const ros::Time& stamp, const Match* match,
                     Eigen::Index particles, double ms_per_update, const ScanSource::Counts& scans,
                     const std::vector<SenseStatus>& senses);

  /// Time jumped back: stamps that were used may come again.
  void forgetStamps() { sent_ = {}; }

 private:
  void publishModes(const std::vector<Mode>& modes, const ros::Time& stamp);
  void sendTransform(const Pose2& T_map_odom, const ros::Time& stamp);

  const NodeOptions& options_;  // the node's, which may change
  ros::Publisher pose_;
  ros::Publisher cloud_;
  ros::Publisher modes_;
  ros::Publisher leaders_;
  ros::Publisher confidence_;
  ros::Publisher status_;
  tf2_ros::TransformBroadcaster broadcaster_;
  bool has_leaders_{false};  // were published last
  std::optional<Pose2> T_map_odom_;
  ros::Time sent_;
  ros::Timer timer_;  // for a transform at a fixed rate
};

}  // namespace adaptive_localization
