// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "eval/calibration.hpp"

namespace adaptive_localization {

/// Which run it was. The settings are a hash of all else that decides the result.
struct RunId {
  std::string experiment, of_case, label;
  int seed{1};
  std::string settings;

  std::string name() const { return experiment + "/" + of_case + "/" + label; }
};

/// One task of finding the robot: from the start, known, told wrong or not told, or after it was
/// put down elsewhere.
struct Trial {
  enum class Kind { kKnownStart, kWrongStart, kStart, kKidnap };

  Kind kind{Kind::kStart};
  double at{0.0};  // s, when the robot was put down
  Pose2 T_map_base;
  std::optional<double> found_s;  // after that the estimate was right, and stayed so for some scans
  std::optional<double> told_s;   // the same, and the status was tracking
  // The same in the words of Li 2016: after that the mean of the particles was validated, as they
  // were kValidSpread from it on average, and was not wrong; and scans at which it was, until then.
  std::optional<double> validated_s;
  int wrongly_validated{0};
  std::optional<double> within_s;  // the time given for it
  std::optional<double> left_s;    // after that it was wrong, though it was found or known
  int scans{0};
  int searching{0};            // scans before it was found
  int searching_tracking{0};   // of these, those that said tracking
  int late_tracking{0};        // of these, those after the time given for it
  int searching_ambiguous{0};  // of those before it was found, those that said ambiguous
  std::string end_status;
  double end_error_m{0.0};
  double end_error_deg{0.0};
  bool is_silent_failure{false};  // says tracking at the end, and is wrong
};

/// How near the estimates came to the truth, over the scans after the robot was found.
struct Accuracy {
  int scans{0};
  double mean_m{0.0}, mean_deg{0.0};

  // Normalised errors squared (consistency.hpp) at updates: the mean, and the first one in each
  // second of the run, none where the robot was not found yet.
  std::optional<double> normalized_mean;
  std::vector<std::optional<double>> normalized;

  // Cramér-Rao bounds (error_bound.hpp), rms: of one scan alone, and of all scans and odometry.
  std::optional<double> scan_bound_m, scan_bound_deg, drive_bound_m, drive_bound_deg;
};

/// What came of one run. An estimate counts as wrong when it is off by more than kLostDistance or
/// kLostHeading.
struct ExperimentResult {
  RunId id;
  std::string filter, preset;
  double duration_s{0.0};
  int scans{0};
  int updates{0};
  std::vector<Trial> trials;

  double settled_s{0.0};  // after the status told, up to the next event or the end
  int left_tracking{0};   // false alarms: how often the status left tracking in that time,
  int false_jumps{0};  // and how often the estimate jumped: was wrong by that before and odometry
  int jumps{0};        // at any time

  int silently_wrong{0};              // scans that said tracking while the estimate was wrong
  double silently_wrong_s{0.0};       // the longest spell of them
  int carried{0};                     // scans while the robot was off the floor,
  int carried_tracking{0};            // those of them that said tracking,
  int carried_jumps{0};               // and those at which the estimate jumped
  std::map<std::string, int> status;  // scans by status

  double first_mass{0.0}, second_mass{0.0};  // of the two heaviest modes, mean while ambiguous
  // Where the map looks the same after half a turn: the share of the scans with a mode at the truth
  // and one at its counterpart.
  std::optional<double> both_share;
  bool has_both_at_end{false};

  Calibration calibration;  // scans while the robot was on the floor

  double rms_m{0.0}, rms_deg{0.0}, max_m{0.0};  // after it was found
  Accuracy accuracy;
  std::vector<double> probe_errors_m;
  /// On the floor: from each way-point that the driver took for reached, and, rms, from its way.
  std::vector<double> arrival_errors_m;
  double way_error_m{0.0};
  int looks_elsewhere{0};  // updates after which hypotheses were drawn elsewhere
  int particles_first{0}, particles_max{0};
  std::vector<int> particles_by_s;  // at the first scan of each second
  double particles_mean{0.0};
  double update_ms_median{0.0}, update_ms_max{0.0};  // processor time of scans that updated
};

std::string toText(Trial::Kind kind);

/// One line of JSON, without its end.
std::string toLine(const ExperimentResult& result);

/// Of such a line. Throws std::invalid_argument for a line that toLine did not make.
RunId idOf(const std::string& line);

}  // namespace adaptive_localization
