// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "kept_place.hpp"
#include "localizer/hypotheses.hpp"
#include "localizer/usual_error.hpp"
#include "match/pose_kalman.hpp"
#include "ser/place_refiner.hpp"

namespace adaptive_localization {
namespace {

/// From where it is and, if a search found it elsewhere, or scans that did not fit led it away,
/// from there.
Place alignedWith(const PlaceRefiner& refiner, const Hypothesis& hypothesis) {
  Place place = hypothesis.aligned ? *hypothesis.aligned : refiner.align(hypothesis.T_map_base);
  for (const std::optional<Pose2>& other : {hypothesis.T_map_found, hypothesis.T_map_fitted}) {
    if (!other || refiner.error(*other) >= place.error) continue;
    const Place again = refiner.align(*other);
    if (Hypotheses::withTolerance(again.error) < place.error) place = again;
  }
  return place;
}

/// Whether a known place would have to slide to where it was aligned, farther than wheels can slip:
/// odometry and the core say that it did not. Where somebody stands in the way, as in an aisle, it
/// would follow him: then no farther than the core did, however far that is.
bool wouldSlide(const Hypothesis& known, const Pose2& aligned, double slide_of_core,
                bool is_hidden) {
  const bool slides = known.slideTo(aligned) > std::max(1.0, slide_of_core);
  return slides && (is_hidden || slide_of_core <= 1.0);
}

}  // namespace

PlaceRefiner Hypotheses::refinerFor(const Scan& scan) const {
  return {ground_.map, ground_.field, scan, scan.max_range, RangeError::kTruncation};
}

void Hypotheses::follow(const Scan& scan, double usual) {
  for (Hypothesis& hypothesis : all_) hypothesis.is_due = true;
  align(refinerFor(scan), usual, false);
}

/// The better one of two ways to the core's place: from where it was and from where the core is.
/// One that leads away from where both odometry and the core have it, as along a wall with gaps,
/// leads to another place: odds that were earned do not go there. Nor does a known place go there
/// step by step: it is where the core is.
Place Hypotheses::alignedCore(const PlaceRefiner& refiner, Hypothesis& hypothesis,
                              const Place& before, double usual) {
  const Pose2 T_map_core = *hypothesis.T_map_core, ridden = hypothesis.T_map_ridden;
  hypothesis.T_map_core.reset();
  const Place now = refiner.align(T_map_core);
  const bool leads_away = distance(before.T_map_base, T_map_core) > kSamePlace &&
                          distance(before.T_map_base, ridden) > distance(T_map_core, ridden);
  if (leads_away) {
    led_to_.push_back({before.T_map_base, hypothesis.log_odds - hypothesis.prior});
    led_to_.back().error = before.error;
  }
  const bool is_now = leads_away || now.error <= withTolerance(before.error);
  const Place& place = is_now ? now : before;
  const double error = refiner.error(T_map_core);
  const bool fits = error <= UsualError(usual).limit();
  if (hypothesis.was_believed) {
    const bool is_hidden = !fits && isHidden(refiner.fit(T_map_core));
    const double slide_of_core = hypothesis.slideTo(T_map_core);
    const bool slides = wouldSlide(hypothesis, place.T_map_base, slide_of_core, is_hidden);
    if (is_hidden && slide_of_core <= 1.0) hypothesis.rollFrom(T_map_core);
    if (slides) return {T_map_core, error};
  }
  is_core_beside_ = !fits && place.error < kFarBetter * error;
  return place;
}

/// Each by itself: all threads do.
void Hypotheses::alignDue(const PlaceRefiner& refiner) {
  std::vector<Hypothesis*> due;
  for (Hypothesis& hypothesis : all_) {
    if (hypothesis.is_due) due.push_back(&hypothesis);
  }
  parallelFor(due.size(), 1, [&](const Chunk& chunk) {
    due[chunk.begin]->aligned = alignedWith(refiner, *due[chunk.begin]);
  });
}

void Hypotheses::align(const PlaceRefiner& refiner, double usual, bool looks_for_slips) {
  least_error_ = RangeError::kTruncation;
  is_core_beside_ = false;
  led_to_.clear();
  slips_sought_ = 0;
  alignDue(refiner);
  const Hypothesis* core = nullptr;
  for (Hypothesis& hypothesis : all_) {
    hypothesis.T_map_ridden = hypothesis.T_map_base;
    if (!hypothesis.is_due) continue;
    Place place = *std::exchange(hypothesis.aligned, {});
    if (hypothesis.T_map_core) {
      core = &hypothesis;
      place = alignedCore(refiner, hypothesis, place, usual);
    }
    if (looks_for_slips && hypothesis.isKnown()) {
      place = lookForSlip(refiner, hypothesis, place, usual);
    }
    hypothesis.settleAt(place, place.error <= UsualError(usual).limit());
    least_error_ = std::min(least_error_, place.error);
  }
  const bool is_right = core && loss(core->error, usual) == 0.0;
  if (!is_right || least_error_ > kGoodFit) return;
  alignTwins(refiner, between(core->T_map_ridden, core->T_map_base), usual);
}

/// Each is a Kalman filter of its own (after Kargas, whom Fidelis and Colombini cite).
Gaussian2 Hypotheses::correctedBySenses(const Hypothesis& hypothesis,
                                        const Observations& observations) const {
  constexpr double kOdometry = 0.1;  // standard deviation per way, m/m and rad/rad
  const double drift = kOdometry * hypothesis.way;
  PoseKalman kalman;
  kalman.reset(
      {hypothesis.T_map_base, hypothesis.covariance + drift * drift * Eigen::Matrix3d::Identity()});
  correctBy(*senses_, observations, kalman);
  return kalman.belief();
}

void Hypotheses::correctBySenses(const Observations& observations) {
  least_error_ = RangeError::kTruncation;
  led_to_.clear();
  is_core_beside_ = false;
  slips_sought_ = 0;
  for (Hypothesis& hypothesis : all_) {
    hypothesis.T_map_ridden = hypothesis.T_map_base;
    if (!hypothesis.is_due) continue;
    const Gaussian2 corrected = correctedBySenses(hypothesis, observations);
    hypothesis.T_map_core.reset();
    hypothesis.T_map_base = corrected.mean;
    hypothesis.covariance = corrected.covariance;
    hypothesis.way = 0.0;
    hypothesis.error =
        senses_->misfit(observations, corrected.mean).value_or(RangeError::kTruncation);
    least_error_ = std::min(least_error_, hypothesis.error);
  }
}

/// What odometry got wrong is the same for all: a place that fits as well as the best does, once it
/// is corrected as the core's was, looks the same.
void Hypotheses::alignTwins(const PlaceRefiner& refiner, const Pose2& correction, double usual) {
  for (Hypothesis& hypothesis : all_) {
    if (!hypothesis.is_due) hypothesis.T_map_base = hypothesis.T_map_ridden * correction;
    if (!hypothesis.is_due || loss(hypothesis.error, usual) == 0.0) continue;
    const Pose2 corrected = hypothesis.T_map_ridden * correction;
    if (refiner.error(corrected) >= hypothesis.error) continue;
    const Place place = refiner.align(corrected);
    if (loss(place.error, usual) > 0.0) continue;
    hypothesis.settleAt(place, true);
    least_error_ = std::min(least_error_, place.error);
  }
}

}  // namespace adaptive_localization
