// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"
#include "core/heading_topics.hpp"
#include "core/landmark_topics.hpp"
#include "core/name_list.hpp"
#include "core/scan_timing.hpp"
#include "core/sonar_topics.hpp"

namespace adaptive_localization {

/// What the node itself is told; everything else goes to the Localizer. Names and defaults are
/// amcl's, where amcl has the option.
struct NodeOptions {
  std::string odom_frame_id{"odom"};
  std::string base_frame_id{"base_link"};
  std::string global_frame_id{"map"};
  std::string scan_topics{"scan"};
  ScanTiming timing;
  HeadingTopics headings;
  LandmarkTopics landmarks;
  SonarTopics sonars;
  bool use_map_topic{false};
  bool first_map_only{false};
  bool map_origin_is_cell_center{false};
  bool tf_broadcast{true};
  double transform_tolerance{0.1};
  double tf_rate{0.0};
  double save_pose_rate{0.5};
  std::string pose_file;
  bool force_update_after_initialpose{false};
  bool force_update_after_set_map{false};
  double std_warn_level_x{0.2};
  double std_warn_level_y{0.2};
  double std_warn_level_yaw{0.1};
  std::string start{"pose"};
  double initial_pose_x{0.0};
  double initial_pose_y{0.0};
  double initial_pose_a{0.0};
  double initial_cov_xx{0.25};
  double initial_cov_yy{0.25};
  double initial_cov_aa{0.06853891945200942};  // (pi / 12)^2

  template <class Visitor>
  void visit(Visitor&& option) {
    option("odom_frame_id", odom_frame_id, Choices{}, "Frame of the odometry.");
    option("base_frame_id", base_frame_id, Choices{}, "Frame of the robot.");
    option("global_frame_id", global_frame_id, Choices{}, "Frame of the map.");
    option("scan_topics", scan_topics, Choices{},
           "Topics with scans, separated by spaces or commas; empty: no laser, the robot is "
           "localized by landmarks or sonars.");
    timing.visit(option);
    headings.visit(option);
    landmarks.visit(option);
    sonars.visit(option);
    option("use_map_topic", use_map_topic,
           "Take the map from topic 'map' instead of service 'static_map'.");
    option("first_map_only", first_map_only, "Ignore all but the first map on the topic.");
    option("map_origin_is_cell_center", map_origin_is_cell_center,
           "The map's origin is the centre of its first cell, not its corner; some map makers "
           "write it so.");
    option("tf_broadcast", tf_broadcast, "Send the transform from map to odom.");
    option("transform_tolerance", transform_tolerance, Range{0, 60}, "s",
           "How far the transform is dated into the future.");
    option("tf_rate", tf_rate, Range{0, 1000}, "Hz",
           "Rate of the transform from map to odom; 0: one with each scan.");
    option("save_pose_rate", save_pose_rate, Range{-1, 1000}, "Hz",
           "Rate at which the pose is saved to the parameters initial_pose_* and initial_cov_*; 0 "
           "or less: never.");
    option("pose_file", pose_file, Choices{},
           "File in which the pose is also saved. If it exists at the start, its pose takes "
           "precedence over start and initial_pose_*; empty: none.");
    option("force_update_after_initialpose", force_update_after_initialpose,
           "After an initial pose, use a second scan whether the robot moved or not.");
    option("force_update_after_set_map", force_update_after_set_map,
           "After set_map, use a second scan whether the robot moved or not.");
    option("std_warn_level_x", std_warn_level_x, kNotNegative, "m",
           "Standard deviation in x above which /diagnostics warns.");
    option("std_warn_level_y", std_warn_level_y, kNotNegative, "m",
           "Standard deviation in y above which /diagnostics warns.");
    option("std_warn_level_yaw", std_warn_level_yaw, kNotNegative, "rad",
           "Standard deviation in yaw above which /diagnostics warns.");
    option("start", start, Choices{"pose", "anywhere", "wait"},
           "pose: initial_pose_*; anywhere: the whole map; wait: none until a message on "
           "initialpose.");
    option("initial_pose_x", initial_pose_x, kCoordinate, "m", "Pose to start at, x.");
    option("initial_pose_y", initial_pose_y, kCoordinate, "m", "Pose to start at, y.");
    option("initial_pose_a", initial_pose_a, kCoordinate, "rad", "Pose to start at, yaw.");
    option("initial_cov_xx", initial_cov_xx, kVariance, "m^2", "Its variance in x.");
    option("initial_cov_yy", initial_cov_yy, kVariance, "m^2", "Its variance in y.");
    option("initial_cov_aa", initial_cov_aa, kVariance, "rad^2", "Its variance in yaw.");
  }

  Gaussian2 initialPose() const {
    Gaussian2 prior;
    prior.mean = {initial_pose_x, initial_pose_y, initial_pose_a};
    prior.covariance.diagonal() << initial_cov_xx, initial_cov_yy, initial_cov_aa;
    return prior;
  }
};

/// A map of one cell to try options on before there is a map, so large that every floor plan is on
/// it: its coordinates are below 1e4 m.
inline std::shared_ptr<const OccupancyGrid> trialMap() {
  return std::make_shared<const OccupancyGrid>(Lattice(1, 1, 2e4, {-1e4, -1e4, 0.0}),
                                               std::vector<std::int8_t>{0});
}

/// The options in effect of node and localizer whose values are others than what the core and the
/// preset of these parameters run with if nothing else is given.
/// Throws std::invalid_argument naming key, value and range.
std::vector<OptionDescription> changedOptions(const Parameters& parameters);

/// With the frames' names as tf2 has them, without a slash in front. Throws std::invalid_argument
/// naming key and value of one that is empty or another one's as well.
NodeOptions withPlainFrames(NodeOptions options);

/// Throws std::invalid_argument naming key and value of what cannot be the name of a topic.
void checkTopics(const NodeOptions& options);

/// Reads the node's options and says which ones differ from the defaults; to the logger "options",
/// at debug level, all of them. Makes a localizer on the trial map on the way, so that wrong
/// parameters show at the start, not with the map.
/// Throws std::invalid_argument naming key, value and range.
NodeOptions readNodeOptions(const Parameters& parameters);

/// What to believe at the start; nothing: wait for an initial pose.
std::optional<Prior> startOf(const NodeOptions& options);

}  // namespace adaptive_localization
