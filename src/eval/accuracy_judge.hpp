// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "adaptive_localization/eval/error_bound.hpp"
#include "adaptive_localization/eval/experiment_result.hpp"
#include "adaptive_localization/localizer/localizer.hpp"

namespace adaptive_localization {

/// Keeps the record of how near the estimates come to the truth.
class AccuracyJudge {
 public:
  /// A scan after the robot was found.
  void observe(double stamp, const Localization& answer, const Pose2& truth,
               const std::optional<ScanBounds>& bounds);

  Accuracy finish() const;

 private:
  void noteNormalized(double stamp, const Localization& answer, const Pose2& truth);

  Accuracy sums_;
  double sum_normalized_{0.0};
  int normalized_scans_{0};
  int bound_scans_{0};
  ErrorBound scan_squares_, drive_squares_;
};

}  // namespace adaptive_localization
