// SPDX-License-Identifier: BSD-3-Clause
#include "estimate_refiner.hpp"

#include <utility>

#include "core/chi_square.hpp"
#include "core/gate.hpp"
#include "filters/shared_parts.hpp"

namespace adaptive_localization {
namespace {

constexpr double kNarrow = 0.2;      // m, a cloud's standard deviation: any good match is its place
constexpr double kWide = 0.6;        // m: up to here only one that explains the scan,
constexpr double kMostOfScan = 0.7;  // so much of it
const double kGate = chiSquare(3, 0.99);

bool isNarrow(const Estimate& estimate, double deviation) {
  return estimate.covariance.topLeftCorner<2, 2>().trace() < deviation * deviation;
}

bool isTrusted(const Match& match, const Estimate& estimate) {
  return match.inlier_ratio >= kMostOfScan || isNarrow(estimate, kNarrow);
}

/// Whether a pose is still of the place that a filter means.
bool isNear(const Estimate& estimate, const Pose2& T_map_base) {
  return isWithin({estimate.T_map_base, estimate.covariance}, T_map_base);
}

}  // namespace

EstimateRefiner::EstimateRefiner(MatchScan match, std::unique_ptr<MotionModel> motion,
                                 Senses senses)
    : tracker_(std::move(match)), motion_(std::move(motion)), senses_(std::move(senses)) {}

void EstimateRefiner::reset() {
  is_on_ = false;
  match_.reset();
}

Estimate EstimateRefiner::refine(Estimate estimate, const Pose2& motion,
                                 const Observations& observations) {
  match_.reset();
  if (!isNarrow(estimate, kWide)) {
    is_on_ = false;
    return estimate;
  }
  if (!goesOnFrom(estimate, motion)) {
    tracker_.reset({estimate.T_map_base, loosened(estimate.covariance)});
    has_explained_ = false;
  }
  tracker_.correctBy(*senses_, observations);
  match_ = tracker_.matchAt(tracker_.mean(), observations.scan);
  is_on_ = tracker_.correct(*match_, [&](const Match& match) {
    const bool is_expected = has_explained_ && tracker_.distanceOf(match) < kGate;
    return (is_expected || isTrusted(match, estimate)) && isNear(estimate, match.T_map_base);
  });
  if (!is_on_) return estimate;
  has_explained_ = has_explained_ || match_->inlier_ratio >= kMostOfScan;
  estimate.T_map_base = tracker_.mean();
  estimate.covariance = tracker_.covariance();
  estimate.modes.front().T_map_base = estimate.T_map_base;
  estimate.modes.front().covariance = estimate.covariance;
  return estimate;
}

bool EstimateRefiner::goesOnFrom(const Estimate& estimate, const Pose2& motion) {
  if (!is_on_) return false;
  tracker_.predict(motion, motion_->covariance(motion));
  return isNear(estimate, tracker_.mean());
}

std::unique_ptr<EstimateRefiner> makeEstimateRefiner(const Registry<MotionDescription>& motions,
                                                     const Parameters& given, const Ground& ground,
                                                     Senses senses) {
  return std::make_unique<EstimateRefiner>(
      matchBy(scanMatcherFor(ground, given.read<MatchOptions>())), makeMotionModel(motions, given),
      std::move(senses));
}

}  // namespace adaptive_localization
