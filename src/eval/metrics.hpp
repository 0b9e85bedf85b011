// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/calibration.hpp"
#include "eval/carryings.hpp"
#include "eval/run.hpp"

namespace adaptive_localization {

/// Errors of the estimate against the reference, at every scan that has one, without any alignment
/// of the trajectories: the absolute trajectory error of Sturm et al. (2012) in a common frame.
struct ErrorMetrics {
  double ate_rmse_m{0.0};
  double ate_mean_m{0.0};
  double ate_median_m{0.0};
  double ate_p95_m{0.0};
  double ate_max_m{0.0};
  double heading_rmse_deg{0.0};
  double final_error_m{0.0};
  double final_heading_error_deg{0.0};
  std::optional<double> converged_at_s;  // after the first scan; from there never lost again
  // Normalised errors squared at updates (consistency.hpp): mean, median, and the share of them in
  // the band of 95 % for one. The reference's own errors are in them.
  std::optional<double> nees_mean, nees_median, nees_in_band;
  double lost_share{0.0};               // of the scans with a reference
  double misled_share{0.0};             // lost and said "tracking", of the same
  double misled_longest_s{0.0};         // the longest time of that
  std::optional<double> tracking_at_s;  // after the first scan; when it first said "tracking"
  Calibration calibration;
  Carryings carryings;
};

/// All numbers of one run.
struct Metrics {
  int scans{0};
  int updates{0};
  double duration_s{0.0};
  double path_m{0.0};  // of the reference; without one, of the odometry
  double wall_s{0.0};
  double cpu_s{0.0};
  double peak_rss_mb{0.0};
  double update_ms_median{0.0}, update_ms_p99{0.0}, update_ms_max{0.0};  // of scans that updated
  double update_ms_first{
      0.0};  // of the first scan, for which all is made that is made when needed,
  double update_ms_longest{0.0};  // and of any other, updated or not
  double update_cpu_ms_median{0.0},
      update_cpu_ms_mean{0.0};  // of scans that updated, processor time
  double particles_mean{0.0};
  int particles_max{0};
  int jumps{0};  // how often the estimate left the odometry by more than kLostDistance
  double confidence_mean{0.0};
  std::optional<ErrorMetrics> errors;    // none without a reference
  std::map<std::string, double> status;  // share of the scans, by status
  double tracking_share{0.0};            // of the updates
  double nowhere_share{0.0};  // of the updates; lost or globalizing: no place explains them
};

Metrics measure(const RunRecord& run);

/// Whether the scans cannot be of this map, or the robot was never found on it, by what the
/// localizer says: it hardly ever says tracking, and often that no place explains the scan. On a
/// map that is poor but right it says ambiguous.
bool isMisfit(const Metrics& metrics);

}  // namespace adaptive_localization
