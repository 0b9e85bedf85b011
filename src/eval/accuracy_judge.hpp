// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "adaptive_localization/localizer/localizer.hpp"
#include "eval/error_bound.hpp"
#include "eval/experiment_result.hpp"

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

  std::vector<double> errors_m_, errors_deg_, normalized_;
  std::vector<std::optional<double>> of_seconds_;  // the first normalised error in each
  std::vector<ScanBounds> bounds_;
};

}  // namespace adaptive_localization
