// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/SetMap.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>

#include <memory>
#include <optional>

#include "adaptive_localization/localizer/localizer.hpp"
#include "continuity.hpp"
#include "core/sweep_watch.hpp"
#include "display.hpp"
#include "estimate_publisher.hpp"
#include "heading_source.hpp"
#include "landmark_source.hpp"
#include "map_builder.hpp"
#include "map_source.hpp"
#include "node_diagnostics.hpp"
#include "node_options.hpp"
#include "odometry.hpp"
#include "places_maker.hpp"
#include "pose_keeper.hpp"
#include "reconfigure.hpp"
#include "scan_source.hpp"
#include "sonar_source.hpp"
#include "transform_input.hpp"

namespace adaptive_localization {

/// The ROS node: amcl's topics, services and parameters around a Localizer. One thread, no locks;
/// only what is made of a new map, and its energy grid, is computed in others.
class LocalizationNode {
 public:
  /// Throws std::invalid_argument naming key, value and range when a parameter is wrong.
  LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node);

  /// Keeps the pose for the next start.
  void writePose() const { pose_keeper_.write(); }

  /// For a bag in place of topics.
  bool hasMap() const { return localizer_ != nullptr; }
  void add(const geometry_msgs::TransformStamped& transform, bool fixed) {
    tf_input_.add(transform, fixed);
  }
  bool hearsScansOn(const std::string& topic) const { return scans_.hears(topic); }
  void add(const sensor_msgs::LaserScan::ConstPtr& scan) { scans_.add(scan); }
  void hear(const BagMessage& message) {
    headings_.add(message);
    sonars_.add(message);
    landmarks_.add(message);
  }
  void localizeAnywhere() { start(Anywhere{}); }
  const std::optional<Localization>& answer() const { return answer_; }
  std::string missing() const { return health().missing; }

 private:
  using PoseWithCovarianceStamped = geometry_msgs::PoseWithCovarianceStamped;

  MapBuilder::Work preparation();
  void onMap(BuiltMap& map);
  bool onScan(const sensor_msgs::LaserScan& message, const LaserMount& mount,
              const ros::SteadyTime& arrival);
  LaserScan believed(const sensor_msgs::LaserScan& message);
  void onOtherSense(const ros::Time& stamp, const Pose2& T_odom_base);
  void localize(const Pose2& T_odom_base, Observations observations, const ros::Time& stamp,
                const std::optional<ros::SteadyTime>& scan_arrival);
  void onTimeJump(double seconds);
  void onOtherTimeJump(const ros::Time& stamp, double seconds);
  void onInitialPose(const PoseWithCovarianceStamped& message);
  bool onGlobalLocalization();
  bool onNoMotionUpdate();
  bool onSetMap(nav_msgs::SetMap::Request& request, nav_msgs::SetMap::Response& response);
  std::vector<OptionDescription> configure(const Parameters& given);
  void start(const Prior& prior);
  void startAround(const Localization& known);
  void requestFollowUps();
  EstimatePublisher::Figures figures(const ros::Time& stamp) const;
  NodeHealth health() const;
  std::vector<SenseStatus> senses() const;

  Parameters parameters_;
  NodeOptions options_;
  Ground map_;
  bool is_map_updated_{false};
  bool is_preparation_current_{false};    // options are those that a map is being prepared with
  std::unique_ptr<Localizer> localizer_;  // once there is a map
  std::optional<Prior> prior_;            // to start from, once there is a map
  std::optional<Localization> answer_;    // to the last scan
  bool is_anywhere_{false};               // was the last start's prior
  bool update_again_{false};              // amcl's force_update_after_*
  int updates_on_trial_{0};               // left to find itself where a jump left it
  double ms_per_update_{0.0};
  ros::Time last_scan_;  // that was used, or the first reading of another sense

  tf2_ros::Buffer tf_;
  TransformInput tf_input_;
  Odometry odometry_;
  OdometryWatch odometry_watch_;
  EstimatePublisher publisher_;
  Display display_;
  ParameterWriter parameter_writer_;
  PoseKeeper pose_keeper_;
  ScanSource scans_;
  SweepWatch sweeps_;
  HeadingSource headings_;
  LandmarkSource landmarks_;
  SonarSource sonars_;
  ros::Subscriber initial_pose_;
  ros::ServiceServer global_localization_;
  ros::ServiceServer no_motion_update_;
  ros::ServiceServer set_map_;
  PlacesMaker places_;
  MapBuilder map_builder_;
  MapSource maps_;
  NodeDiagnostics diagnostics_;
  Reconfigure reconfigure_;
};

}  // namespace adaptive_localization
