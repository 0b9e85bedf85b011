// SPDX-License-Identifier: BSD-3-Clause
#include "estimate_publisher.hpp"

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <std_msgs/Float32.h>

#include <algorithm>

#include "callbacks.hpp"
#include "conversions.hpp"
#include "status_message.hpp"

namespace adaptive_localization {
namespace {

using diagnostic_msgs::DiagnosticStatus;

DiagnosticStatus::_level_type levelOf(Status status) {
  if (status == Status::kTracking) return DiagnosticStatus::OK;
  return status == Status::kLost ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN;
}

constexpr std::size_t kModesInStatus = 5;
constexpr std::size_t kModesSent = 100;

}  // namespace

EstimatePublisher::EstimatePublisher(ros::NodeHandle node, ros::NodeHandle private_node,
                                     const NodeOptions& options)
    : options_(options),
      pose_(node.advertise<geometry_msgs::PoseWithCovarianceStamped>("amcl_pose", 2, true)),
      cloud_(node.advertise<geometry_msgs::PoseArray>("particlecloud", 2, true)),
      modes_(private_node.advertise<geometry_msgs::PoseArray>("modes", 2, true)),
      leaders_(private_node.advertise<geometry_msgs::PoseArray>("leaders", 2, true)),
      confidence_(private_node.advertise<std_msgs::Float32>("confidence", 2, true)),
      status_(private_node.advertise<DiagnosticStatus>("status", 2, true)) {
  if (!options.tf_broadcast || options.tf_rate <= 0.0) return;
  timer_ = every(node, ros::Duration(1.0 / options.tf_rate), "Transform", [this] {
    if (T_map_odom_) sendTransform(*T_map_odom_, ros::Time::now());
  });
}

void EstimatePublisher::publish(const Localization& answer, const Particles& particles,
                                const ros::Time& stamp) {
  if (answer.updated) {
    geometry_msgs::PoseWithCovarianceStamped pose;
    pose.header.stamp = stamp;
    pose.header.frame_id = options_.global_frame_id;
    pose.pose = toMessage(answer.T_map_base, answer.covariance);
    pose_.publish(pose);

    geometry_msgs::PoseArray cloud = toMessage(particles);
    cloud.header.stamp = ros::Time::now();
    cloud.header.frame_id = options_.global_frame_id;
    cloud_.publish(cloud);
    publishModes(answer.modes, stamp);
  }
  T_map_odom_ = answer.T_map_odom;
  if (options_.tf_broadcast && options_.tf_rate <= 0.0) sendTransform(answer.T_map_odom, stamp);
  std_msgs::Float32 confidence;
  confidence.data = static_cast<float>(answer.confidence);
  confidence_.publish(confidence);
}

/// Heaviest first; their masses are in the status.
void EstimatePublisher::publishModes(const std::vector<Mode>& modes, const ros::Time& stamp) {
  geometry_msgs::PoseArray message;
  message.header.stamp = stamp;
  message.header.frame_id = options_.global_frame_id;
  for (std::size_t i = 0; i < std::min(modes.size(), kModesSent); ++i) {
    message.poses.push_back(toPoseMessage(modes[i].T_map_base));
  }
  modes_.publish(message);
}

void EstimatePublisher::publishLeaders(const Particles& leaders, const ros::Time& stamp) {
  if (leaders.size() == 0 && !has_leaders_) return;
  has_leaders_ = leaders.size() > 0;
  geometry_msgs::PoseArray message = toMessage(leaders);
  message.header.stamp = stamp;
  message.header.frame_id = options_.global_frame_id;
  leaders_.publish(message);
}

void EstimatePublisher::sendTransform(const Pose2& T_map_odom, const ros::Time& stamp) {
  if (stamp <= sent_) return;  // tf complains about a stamp given twice; two lasers may share one
  sent_ = stamp;
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stamp + ros::Duration(options_.transform_tolerance);
  transform.header.frame_id = options_.global_frame_id;
  transform.child_frame_id = options_.odom_frame_id;
  transform.transform = toTransformMessage(T_map_odom);
  broadcaster_.sendTransform(transform);
}

void EstimatePublisher::publishStatus(const Localization& answer, const ros::Time& stamp,
                                      const Match* match, Eigen::Index particles,
                                      double ms_per_update, const ScanSource::Counts& scans,
                                      const std::vector<SenseStatus>& senses) {
  DiagnosticStatus status =
      makeStatus("localization", levelOf(answer.status), toText(answer.status));
  add(status, "stamp", print("%u.%09u", stamp.sec, stamp.nsec));
  add(status, "updated", answer.updated ? "yes" : "no");
  add(status, "confidence", print("%.3f", answer.confidence));
  const auto& modes = answer.modes;
  add(status, "modes", std::to_string(modes.size()));
  for (std::size_t i = 0; i < std::min(modes.size(), kModesInStatus); ++i) {
    const Pose2& pose = modes[i].T_map_base;
    add(status, "mode " + std::to_string(i + 1),
        print("mass %.3f at x %.3f m, y %.3f m, yaw %.1f deg", modes[i].mass, pose.x, pose.y,
              pose.theta * 180.0 / kPi));
  }
  if (match) {
    add(status, "match", match->isGood() ? "used" : toText(match->fault));
    add(status, "match inliers", print("%.3f", match->inlier_ratio));
  }
  add(status, "particles", std::to_string(particles));
  add(status, "ms per update", print("%.3f", ms_per_update));
  addCounts(status, scans);
  addSenses(status, senses);
  status_.publish(status);
}

}  // namespace adaptive_localization
