// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/eval/accuracy_summary.hpp"
#include "adaptive_localization/eval/experiment_result.hpp"
#include "adaptive_localization/eval/statistics.hpp"

namespace adaptive_localization {

/// Results of the runs with the same experiment, case and core, over seeds. Trials are those of
/// starts that were not known and of kidnaps; a trial that failed counts as never in the quantiles.
struct ExperimentSummary {
  std::string experiment, of_case, label, filter, preset;
  int runs{0};
  Share found;
  std::optional<double> found_median_s, found_p95_s, told_median_s, told_p95_s;  // none: never
  // The same of the trials in which no scan said ambiguous before.
  std::optional<double> clear_median_s, clear_p95_s;
  std::vector<double> found_s;  // of those that were found, ascending
  Share in_time;                // of the trials with a time for it, those found in it
  Share in_time_or_flagged;  // or in which from then on no scan said tracking before it was found
  Share right_at_end;        // trials at whose end the estimate was not wrong
  Share left;  // starts that were known and at which the estimate was wrong ever after
  // Scans of a trial that said tracking before the robot was found.
  double told_early_median{0.0}, told_early_most{0.0};
  Share silent_failures;  // trials at whose end the status was tracking, wrongly
  Share flagged;          // trials in which no scan said tracking before the robot was found
  Share ambiguous;        // trials in which one said ambiguous before
  double settled_h{0.0};
  int left_tracking{0}, false_jumps{0};
  double jumps_per_run{0.0};
  double silently_wrong_share{0.0}, silently_wrong_longest_s{0.0};
  Calibration calibration;
  int carried{0}, carried_jumps{0};  // scans
  double carried_tracking_share{0.0};
  Share both_at_end;  // of the runs in which the map looks the same after half a turn
  double both_share{0.0}, first_mass{0.0}, second_mass{0.0};
  double tracking_share{0.0};  // of all scans
  AccuracySummary accuracy;
  double rms_median_m{0.0}, rms_median_deg{0.0}, max_m{0.0};
  std::vector<double> probe_mean_m, probe_std_m;
  // Where the driver steers by the estimate, on the floor: from the way-points that it reached, of
  // all runs, from its way, and way-points in a minute.
  double arrival_median_m{0.0}, arrival_95_m{0.0}, arrival_largest_m{0.0};
  double way_error_median_m{0.0}, arrivals_per_min{0.0};
  double looks_elsewhere{0.0};         // per run
  std::vector<double> particles_by_s;  // N(t), mean of the runs that last so long
  double particles_first{0.0}, particles_mean{0.0};
  int particles_max{0};
  double update_ms_median{0.0}, update_ms_max{0.0};
};

/// One summary for each experiment, case and core, in alphabetical order. The order of the results
/// does not matter, nor whether a run is there twice.
/// Throws std::invalid_argument when runs of one row were made with different settings.
std::vector<ExperimentSummary> summarize(std::vector<ExperimentResult> results);

/// Tables in Markdown, one for each experiment, with the columns in which it has something to say.
std::string toTables(const std::vector<ExperimentSummary>& summaries);

nlohmann::json toJson(const ExperimentSummary& summary);

}  // namespace adaptive_localization
