// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/localizer/localizer.hpp"
#include "eval/log.hpp"

namespace adaptive_localization {

/// What the localizer answered to one scan.
struct RunStep {
  double stamp{0.0};  // s
  Pose2 T_odom_base;
  Pose2 T_map_base;                                     // the estimate
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};  // of the last update
  std::optional<Pose2> T_map_base_reference;
  double confidence{0.0};
  Status status{Status::kUninitialised};
  bool updated{false};
  double update_ms{0.0};  // spent on this scan
  double cpu_ms{0.0};     // the same and the search after it, all threads' processor time
  int particles{0};
  double fit{0.0};  // of the scan at the estimate, as the confidence has it
  int modes{0};     // places where the robot may be
};

/// What there is to look at of a scan: poses and points in the map.
struct RunView {
  double stamp{0.0};  // s
  std::vector<Mode> modes;
  Eigen::Array3Xd hits;       // x, y in m, and how far they are from the map's walls, m
  Eigen::Array3Xd particles;  // x, y, theta; of many some
};

/// A whole recording driven through the localizer.
struct RunRecord {
  std::vector<RunStep> steps;
  std::vector<RunView> views;  // of some of them
  std::vector<std::string> warnings;
  int skipped{0};           // scans that could not be used
  double wall_s{0.0};       // from the first scan to the last
  double cpu_s{0.0};        // the same, all threads
  double peak_rss_mb{0.0};  // of the whole process
};

/// Called after each scan with the number of scans done.
using RunProgress = std::function<void(std::size_t)>;

/// How the robot moved, by odometry, from scan i to the next, or from the one before where the next
/// is missing; standing where both are more than half a second away. For scans that are swept.
BaseVelocity velocityAt(const Log& log, std::size_t i);

/// Drives the localizer, which has its prior already, through all scans of the log, as fast as it
/// goes, and keeps so many views, evenly spread. Scans that cannot be used are left out, with a
/// warning; std::invalid_argument if all are.
RunRecord runLog(const Log& log, Localizer& localizer, const RunProgress& progress = {},
                 std::size_t views = 0);

}  // namespace adaptive_localization
