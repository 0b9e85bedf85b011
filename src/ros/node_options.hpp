// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/filter.hpp"
#include "adaptive_localization/options.hpp"

namespace adaptive_localization {

/// What the node itself is told; everything else goes to the Localizer. Names and defaults are
/// amcl's, where amcl has the option.
struct NodeOptions {
  std::string odom_frame_id{"odom"};
  std::string base_frame_id{"base_link"};
  std::string global_frame_id{"map"};
  bool use_map_topic{false};
  bool first_map_only{false};
  bool tf_broadcast{true};
  double transform_tolerance{0.1};
  double save_pose_rate{0.5};
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
    option("use_map_topic", use_map_topic,
           "Take the map from topic 'map' instead of service 'static_map'.");
    option("first_map_only", first_map_only, "Ignore all but the first map on the topic.");
    option("tf_broadcast", tf_broadcast, "Send the transform from map to odom.");
    option("transform_tolerance", transform_tolerance, Range{0, 60}, "s",
           "How far the transform is dated into the future.");
    option("save_pose_rate", save_pose_rate, Range{-1, 1000}, "Hz",
           "How often the pose is kept in initial_pose_* and initial_cov_*; not above 0: never.");
    option("start", start, Choices{"pose", "anywhere", "wait"},
           "Start at initial_pose_*, anywhere on the map, or wait for an initialpose.");
    option("initial_pose_x", initial_pose_x, kAnyNumber, "m", "Pose to start at, x.");
    option("initial_pose_y", initial_pose_y, kAnyNumber, "m", "Pose to start at, y.");
    option("initial_pose_a", initial_pose_a, kAnyNumber, "rad", "Pose to start at, yaw.");
    option("initial_cov_xx", initial_cov_xx, kNotNegative, "m^2", "Its variance in x.");
    option("initial_cov_yy", initial_cov_yy, kNotNegative, "m^2", "Its variance in y.");
    option("initial_cov_aa", initial_cov_aa, kNotNegative, "rad^2", "Its variance in yaw.");
  }

  Gaussian2 initialPose() const {
    Gaussian2 prior;
    prior.mean = {initial_pose_x, initial_pose_y, initial_pose_a};
    prior.covariance.diagonal() << initial_cov_xx, initial_cov_yy, initial_cov_aa;
    return prior;
  }
};

}  // namespace adaptive_localization
