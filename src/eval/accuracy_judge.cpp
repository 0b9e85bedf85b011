// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy_judge.hpp"

#include <algorithm>
#include <cmath>

#include "eval/consistency.hpp"
#include "eval/statistics.hpp"

namespace adaptive_localization {
namespace {

constexpr double kDegrees = 180.0 / kPi;

}  // namespace

void AccuracyJudge::observe(double stamp, const Localization& answer, const Pose2& truth,
                            const std::optional<ScanBounds>& bounds) {
  errors_m_.push_back(distance(answer.T_map_base, truth));
  errors_deg_.push_back(kDegrees * std::abs(wrapAngle(answer.T_map_base.theta - truth.theta)));
  if (answer.updated) noteNormalized(stamp, answer, truth);
  if (bounds) bounds_.push_back(*bounds);
}

void AccuracyJudge::noteNormalized(double stamp, const Localization& answer, const Pose2& truth) {
  const auto error = normalizedError(answer.estimate.T_map_base, answer.estimate.covariance, truth);
  if (!error) return;
  normalized_.push_back(*error);
  const auto second = static_cast<std::size_t>(std::max(stamp, 0.0));
  if (of_seconds_.size() <= second) of_seconds_.resize(second + 1);
  if (!of_seconds_[second]) of_seconds_[second] = *error;
}

Accuracy AccuracyJudge::finish() const {
  Accuracy result;
  result.scans = static_cast<int>(errors_m_.size());
  result.mean_m = mean(errors_m_);
  result.mean_deg = mean(errors_deg_);
  result.normalized = of_seconds_;
  if (!normalized_.empty()) result.normalized_mean = mean(normalized_);
  if (bounds_.empty()) return result;
  const auto rms = [this](ErrorBound ScanBounds::*of, double ErrorBound::*what) {
    return rootMeanSquare(valuesOf(bounds_, [&](const auto& bounds) { return bounds.*of.*what; }));
  };
  result.scan_bound_m = rms(&ScanBounds::of_scan, &ErrorBound::position);
  result.scan_bound_deg = kDegrees * rms(&ScanBounds::of_scan, &ErrorBound::heading);
  result.drive_bound_m = rms(&ScanBounds::of_drive, &ErrorBound::position);
  result.drive_bound_deg = kDegrees * rms(&ScanBounds::of_drive, &ErrorBound::heading);
  return result;
}

}  // namespace adaptive_localization
