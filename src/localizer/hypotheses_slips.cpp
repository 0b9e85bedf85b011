// SPDX-License-Identifier: BSD-3-Clause
// Where the wheels can have slipped to from the place that was known.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.hpp"
#include "localizer/hypotheses.hpp"
#include "localizer/usual_error.hpp"
#include "ser/place_refiner.hpp"

namespace adaptive_localization {
namespace {

/// Wheels can have slipped so far, and turned by so much.
bool isSlip(const Pose2& slip) {
  constexpr double kWay = 1.0, kTurn = 1.0;  // m, rad
  return std::hypot(slip.x, slip.y) < kWay && std::abs(slip.theta) < kTurn;
}

/// Wheels slipped in a turn, and the robot is still in the same place.
bool hasTurned(const Hypothesis& kept, const Pose2& T_map_slipped) {
  constexpr double kTurned = 0.25;  // rad
  const double turned = wrapAngle(T_map_slipped.theta - kept.T_map_ridden.theta);
  return std::abs(turned) > kTurned && areSamePlace(T_map_slipped, kept.T_map_ridden) &&
         kept.shiftTo(T_map_slipped) <= 1.0;
}

/// The best place a slip of the wheels, or a few, away from where odometry has the robot: of all
/// that can be, those where hits are nearest to obstacles are aligned.
Place slippedFrom(const PlaceRefiner& refiner, const Pose2& ridden) {
  constexpr std::size_t kAligned = 6;
  constexpr int kWays = 8, kTurns = 3;
  constexpr double kStep = 0.4, kTurn = 0.3;  // m, rad
  std::vector<Place> places;
  const auto tryFrom = [&](const Pose2& slip) { places.push_back({ridden * slip}); };
  for (const double far : {kStep, 2.0 * kStep}) {
    for (int i = 0; i < kWays; ++i) {
      const double way = 2.0 * kPi * i / kWays;
      tryFrom({far * std::cos(way), far * std::sin(way), 0.0});
    }
  }
  for (int i = -kTurns; i <= kTurns; ++i) tryFrom({0.0, 0.0, kTurn * i});
  const auto forAll = [&](Place (PlaceRefiner::*moved)(const Pose2&) const) {
    parallelFor(places.size(), 1, [&](const Chunk& chunk) {
      places[chunk.begin] = (refiner.*moved)(places[chunk.begin].T_map_base);
    });
  };
  forAll(&PlaceRefiner::approach);
  std::stable_sort(places.begin(), places.end(), fitsBetter);
  places.resize(kAligned);
  forAll(&PlaceRefiner::align);
  return *std::min_element(places.begin(), places.end(), fitsBetter);
}

}  // namespace

void Hypotheses::addCore(const Pose2& T_map_core, double log_odds) {
  if (all_.empty() || all_.size() >= kMostOfAll || knows(T_map_core) || !isFinite(T_map_core))
    return;
  const Hypothesis* from = nullptr;
  for (const Hypothesis& hypothesis : all_) {
    const bool is_likeliest = !from || hypothesis.log_odds > from->log_odds;
    const bool is_from = isSlip(between(hypothesis.T_map_base, T_map_core));
    if (hypothesis.isKnown() && is_likeliest && is_from) from = &hypothesis;
  }
  if (!from) return all_.push_back({T_map_core, log_odds});
  Hypothesis slip = from->slippedTo(T_map_core);
  slip.log_odds = std::max(slip.log_odds, log_odds);
  all_.push_back(slip);
}

bool Hypotheses::haveSlipped(const Pose2& T_map_from, const Pose2& T_map_to) const {
  const bool is_slip = isSlip(between(T_map_from, T_map_to));
  if (all_.empty()) return is_slip;
  const auto place = placeAt(all_, T_map_to);
  return place != all_.end() && (place->has_slipped || is_slip);
}

bool Hypotheses::fitOnlySlip(const Pose2& T_map_to) const {
  const auto slip = placeAt(all_, T_map_to);
  if (slip == all_.end() || !slip->has_slipped || !slip->is_explained) return false;
  return std::any_of(all_.begin(), all_.end(), [&](const Hypothesis& known) {
    return known.was_believed && !known.is_explained && slip->error < kFarBetter * known.error;
  });
}

/// A place that was known and does not fit may be a slip away, which is likelier than any other. It
/// becomes one of its own, since a map where walls are missing may deceive; if it is there already,
/// as the core went there, it is as likely. Where it is still the same place, the known one is
/// there.
Place Hypotheses::lookForSlip(const PlaceRefiner& refiner, const Hypothesis& kept,
                              const Place& aligned, double usual) {
  const double most = UsualError(usual).limit();
  if (refiner.errorPerHit(aligned) <= most) return aligned;
  ++slips_sought_;
  const Place slipped = slippedFrom(refiner, kept.T_map_ridden);
  if (slipped.error > std::min(most, kFarBetter * aligned.error)) return aligned;
  if (hasTurned(kept, slipped.T_map_base)) return slipped;
  Hypothesis slip = kept.slippedTo(slipped.T_map_base);
  slip.error = slipped.error;
  const auto known = placeAt(all_, slipped.T_map_base);
  if (known == all_.end()) {
    led_to_.push_back(slip);
  } else if (known->is_new && !known->was_believed && known->log_odds < slip.log_odds) {
    known->log_odds = slip.log_odds;
    known->word = slip.word;
    known->has_slipped = true;
  }
  return aligned;
}

}  // namespace adaptive_localization
