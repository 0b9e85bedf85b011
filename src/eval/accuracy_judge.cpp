// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy_judge.hpp"

#include <algorithm>
#include <cmath>

#include "adaptive_localization/eval/consistency.hpp"

namespace adaptive_localization {
namespace {

constexpr double kDegrees = 180.0 / kPi;

void addSquares(const ErrorBound& bound, ErrorBound& sums) {
  sums.position += bound.position * bound.position;
  sums.heading += bound.heading * bound.heading;
}

}  // namespace

void AccuracyJudge::observe(double stamp, const Localization& answer, const Pose2& truth,
                            const std::optional<ScanBounds>& bounds) {
  ++sums_.scans;
  sums_.mean_m += distance(answer.T_map_base, truth);
  sums_.mean_deg += kDegrees * std::abs(wrapAngle(answer.T_map_base.theta - truth.theta));
  if (answer.updated) noteNormalized(stamp, answer, truth);
  if (!bounds) return;
  ++bound_scans_;
  addSquares(bounds->of_scan, scan_squares_);
  addSquares(bounds->of_drive, drive_squares_);
}

void AccuracyJudge::noteNormalized(double stamp, const Localization& answer, const Pose2& truth) {
  const auto error = normalizedError(answer.estimate.T_map_base, answer.estimate.covariance, truth);
  if (!error) return;
  sum_normalized_ += *error;
  ++normalized_scans_;
  const auto second = static_cast<std::size_t>(std::max(stamp, 0.0));
  if (sums_.normalized.size() <= second) sums_.normalized.resize(second + 1);
  if (!sums_.normalized[second]) sums_.normalized[second] = *error;
}

Accuracy AccuracyJudge::finish() const {
  Accuracy result = sums_;
  if (result.scans > 0) {
    result.mean_m /= result.scans;
    result.mean_deg /= result.scans;
  }
  if (normalized_scans_ > 0) result.normalized_mean = sum_normalized_ / normalized_scans_;
  if (bound_scans_ > 0) {
    const auto rms = [this](double squares) { return std::sqrt(squares / bound_scans_); };
    result.scan_bound_m = rms(scan_squares_.position);
    result.scan_bound_deg = kDegrees * rms(scan_squares_.heading);
    result.drive_bound_m = rms(drive_squares_.position);
    result.drive_bound_deg = kDegrees * rms(drive_squares_.heading);
  }
  return result;
}

}  // namespace adaptive_localization
