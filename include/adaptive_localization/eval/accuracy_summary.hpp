// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "adaptive_localization/eval/consistency.hpp"
#include "adaptive_localization/eval/experiment_result.hpp"

namespace adaptive_localization {

/// How near the estimates came to the truth, over the runs in which the robot was found.
struct AccuracySummary {
  int runs{0};
  double mean_m{0.0}, mean_deg{0.0};  // mean over runs
  double worst_mean_m{0.0};           // of a run
  double rms_m{0.0}, rms_deg{0.0};    // over all runs
  std::optional<double> scan_bound_m, scan_bound_deg, drive_bound_m, drive_bound_deg;  // the same

  // Normalised errors squared: the mean over time and runs, the band in which the mean over so many
  // runs lies at 95 % of all moments if the filter is consistent, and the share of the seconds at
  // which it does.
  std::optional<double> normalized;
  Band band;
  double seconds_in_band{0.0};
};

AccuracySummary summarizeAccuracy(const std::vector<ExperimentResult>& runs);

}  // namespace adaptive_localization
