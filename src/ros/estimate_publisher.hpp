// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>
#include <std_msgs/Float32.h>
#include <tf2_ros/transform_broadcaster.h>

#include <optional>
#include <vector>

#include "adaptive_localization/localizer/localizer.hpp"
#include "latched_topic.hpp"
#include "latency.hpp"
#include "node_options.hpp"
#include "scan_source.hpp"
#include "sense_health.hpp"

namespace adaptive_localization {

/// What the node tells the world: amcl_pose, particlecloud, map -> odom, ~modes, ~leaders,
/// ~confidence and ~status.
class EstimatePublisher {
 public:
  EstimatePublisher(ros::NodeHandle node, ros::NodeHandle private_node, const NodeOptions& options);

  /// After a scan, which arrived then, was used, or something else in its place. The transform goes
  /// out every time (or at its own rate), pose, cloud and modes only after an update.
  void publish(const Localization& answer, const Particles& particles, const ros::Time& stamp,
               const std::optional<ros::SteadyTime>& scan_arrival);

  /// The leaders of a swarm; none, once, when a filter has no more: the topic is latched.
  void publishLeaders(const Particles& leaders, const ros::Time& stamp);

  /// What the status tells beside the answer to the scan of this stamp.
  struct Figures {
    ros::Time stamp;
    std::optional<MatchFault> match;  // of the last update, and so is
    double match_inliers{0.0};        // its share of hits that fit, if there is one,
    double ms_per_update{0.0};        // and this
    Eigen::Index particles{0};
    ScanSource::Counts scans;
    std::vector<SenseStatus> senses;
  };
  /// The status in words with its figures.
  void publishStatus(const Localization& answer, const Figures& figures);

  /// Time jumped back: stamps that were used may come again.
  void forgetStamps() { sent_ = {}; }

  /// Of the scans that brought about transforms.
  Latency::Minute latency() const;

 private:
  geometry_msgs::PoseWithCovarianceStamped pose() const;
  geometry_msgs::PoseArray cloud() const;
  geometry_msgs::PoseArray modes() const;
  geometry_msgs::PoseArray leaders() const;
  std_msgs::Float32 confidence() const;
  diagnostic_msgs::DiagnosticStatus status() const;
  std_msgs::Header headerAt(const ros::Time& stamp) const;
  void sendTransform(const Pose2& T_map_odom, const ros::Time& stamp);

  const NodeOptions& options_;  // the node's, which may change
  // What messages are made of, once somebody asks for them.
  struct Update {
    ros::Time stamp;
    ros::Time made;
    Localization answer;
    Particles particles;
  };
  Update update_;  // the last
  Particles leaders_;
  ros::Time leaders_stamp_;
  double confidence_{0.0};
  Localization answer_;  // the last, of an update or not
  Figures figures_;

  LatchedTopic<geometry_msgs::PoseWithCovarianceStamped> pose_topic_;
  LatchedTopic<geometry_msgs::PoseArray> cloud_topic_;
  LatchedTopic<geometry_msgs::PoseArray> modes_topic_;
  LatchedTopic<geometry_msgs::PoseArray> leaders_topic_;
  LatchedTopic<std_msgs::Float32> confidence_topic_;
  LatchedTopic<diagnostic_msgs::DiagnosticStatus> status_topic_;
  tf2_ros::TransformBroadcaster broadcaster_;
  std::optional<Pose2> T_map_odom_;
  ros::Time sent_;

  struct ScanTimes {
    ros::Time stamp;
    ros::SteadyTime arrival;
  };
  std::optional<ScanTimes> unsent_;  // of a scan whose transform was not sent yet
  Latency latency_;
  ros::Timer timer_;  // for a transform at a fixed rate
};

}  // namespace adaptive_localization
