// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "accuracy_judge.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "eval/experiment.hpp"
#include "eval/experiment_result.hpp"

namespace adaptive_localization {

constexpr double kValidSpread = 0.14;  // m

/// One scan, what the localizer answered and what was true.
struct JudgedScan {
  double stamp{0.0};  // s
  Pose2 T_odom_base;
  std::optional<Pose2> T_map_base;  // none while the robot is off the floor
  Localization answer;
  int particles{0};
  std::optional<double> spread;  // mean distance of the particles from their mean, m; of some
  double update_ms{0.0};
  std::optional<ScanBounds> bounds;
};

/// Watches a run and keeps the record.
class ExperimentJudge {
 public:
  explicit ExperimentJudge(const ExperimentCase& of_case)
      : rule_(of_case.success), half_turn_(of_case.half_turn), probes_(of_case.probes) {}

  /// The robot stands at a new place.
  void begin(Trial::Kind kind, double at, const Pose2& T_map_base);

  /// The robot is off the floor.
  void lift() { endTrial(); }

  void observe(const JudgedScan& scan);

  /// All but the id, filter and preset.
  ExperimentResult finish();

 private:
  /// A run of scans for which something held.
  struct Held {
    int scans{0};
    double since{0.0};
    void note(bool holds, double stamp);
  };

  void endTrial();
  std::optional<Pose2> truthFor(const JudgedScan& scan) const;
  void noteTrial(const JudgedScan& scan, bool is_right);
  void noteValid(const JudgedScan& scan);
  void noteAlarms(const JudgedScan& scan);
  void noteWrong(const JudgedScan& scan);
  void noteModes(const JudgedScan& scan);
  void noteProbes(const JudgedScan& scan);

  SuccessRule rule_;
  std::optional<Pose2> half_turn_;
  std::vector<double> probes_;
  ExperimentResult result_;

  bool has_trial_{false};
  Held right_, told_, silent_;
  bool is_settled_{false};
  std::optional<JudgedScan> before_;
  std::vector<double> errors_m_, errors_rad_, times_, counts_;
  AccuracyJudge accuracy_;
  double first_masses_{0.0}, second_masses_{0.0};
  int ambiguous_{0}, both_{0}, judged_modes_{0};
};

}  // namespace adaptive_localization
