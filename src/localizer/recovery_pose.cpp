// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "localizer/recovery.hpp"
#include "ser/place.hpp"

namespace adaptive_localization {
namespace {

constexpr double kRuledOut = 0.05;  // mass, at the most

struct Point {
  double belief, share;
};

/// Linear between points, by belief.
template <std::size_t N>
double shareAt(double belief, const std::array<Point, N>& points) {
  for (std::size_t i = 1; i < N; ++i) {
    const auto& [from, least] = points[i - 1];
    const auto& [to, most] = points[i];
    if (belief <= to) return least + (most - least) * (belief - from) / (to - from);
  }
  return points.back().share;
}

/// How often a place that is one of several is the right one, by the belief in it: odds know
/// nothing of what a map does not show, nor of somebody who told a wrong place. Values were fitted
/// to some hundred thousand scans, in worlds of places that look alike and on recordings with poor
/// maps (calibration of probabilities: Niculescu-Mizil and Caruana 2005).
double shareOfRightPlaces(double belief, bool is_by_scans) {
  constexpr std::array<Point, 10> kByScans{{{0.0, 0.0},
                                            {0.03, 0.2},
                                            {0.15, 0.25},
                                            {0.2, 0.4},
                                            {0.35, 0.5},
                                            {0.6, 0.58},
                                            {0.8, 0.66},
                                            {0.9, 0.8},
                                            {0.97, 0.93},
                                            {1.0, 0.98}}};
  constexpr std::array<Point, 11> kTold{{{0.0, 0.0},
                                         {0.05, 0.15},
                                         {0.1, 0.17},
                                         {0.17, 0.5},
                                         {0.82, 0.55},
                                         {0.825, 0.63},
                                         {0.95, 0.65},
                                         {0.985, 0.69},
                                         {0.99, 0.73},
                                         {0.999, 0.79},
                                         {1.0, 0.8}}};
  return is_by_scans ? shareAt(belief, kByScans) : shareAt(belief, kTold);
}

/// A tracked pose is right where the fit is moderate, too: people stand about, a map is old.
double shareOfRightTracks(double belief) {
  return 0.9 + 0.1 * belief;
}

}  // namespace

/// The place that a pose is in while several are possible, if it is about as likely as any.
const Mode* Recovery::heldPlace(const Pose2& T_map_base) const {
  constexpr double kFair = 0.3;  // mass
  const Mode* mode = status_ == Status::kAmbiguous ? modeAt(T_map_base, modes_) : nullptr;
  return mode && mode->mass > std::min(kFair, 0.5 * modes_.front().mass) ? mode : nullptr;
}

void Recovery::noteLeeway(const Estimate& estimate) {
  if (race_.has_left) return leeway_.end();
  if (status_ == Status::kTracking) leeway_.moveTo(estimate.T_map_base);
  leeway_.note(estimate, is_settled_);
}

/// Where the core's cloud has shrunk to there is the known place, too, if that fits far worse where
/// odometry has it.
void Recovery::keepUp(const Pose2& T_map_core, const Observations& observations) {
  constexpr double kFarBetter = 0.5;  // of the error
  if (leeway_.isAt(T_map_core) || !leeway_.allows(T_map_core)) return;
  Hypothesis* known = hypotheses_.knownWithin(leeway_);
  if (!known || error_ >= kFarBetter * errorAt(known->T_map_ridden, observations)) return;
  known->moveTo(T_map_core);
  leeway_.moveTo(T_map_core);
}

/// The scan fits where the core has the robot, to where the wheels slipped, and where odometry has
/// it is ruled out: by the odds, as the core's place is the only one, or as this scan fits far
/// worse there. Odds that were earned would hold the pose for metres.
bool Recovery::hasSlipped(const Pose2& T_map_base_by_odometry, const Pose2& T_map_base) const {
  const bool is_ruled_out = is_settled_ || shareOf(T_map_base_by_odometry) < kRuledOut ||
                            hypotheses_.fitOnlySlip(T_map_base);
  return scan_fits_ && is_ruled_out && hypotheses_.haveSlipped(T_map_base_by_odometry, T_map_base);
}

/// A robot that was known or told to be somewhere is there, as the core has it, until that place is
/// ruled out and another one, that explains the scan well, is likelier than all others: what a core
/// makes of a blocked laser is no reason to jump. One that was not stays in one of the likely
/// places; so does one that left such a place some way ago, if the core is in one.
bool Recovery::isCorrection(const Pose2& T_map_base_by_odometry, const Pose2& T_map_base) const {
  constexpr double kLikely = 0.97, kWell = 0.1;  // mass, m
  constexpr double kFarFromIt = 3.0;             // m, of way
  if (status_ == Status::kTracking || areSamePlace(T_map_base_by_odometry, T_map_base)) return true;
  if (status_ == Status::kAmbiguous && is_settled_ && !proof_.isGiven()) return true;
  if (!was_tracking_ && proof_.isByScans()) return !heldPlace(T_map_base_by_odometry);
  if (hasSlipped(T_map_base_by_odometry, T_map_base)) return true;
  if (leeway_.isAt(T_map_base) && leeway_.allows(T_map_base_by_odometry)) return true;
  if (race_.left_way > kFarFromIt && heldPlace(T_map_base))
    return !heldPlace(T_map_base_by_odometry);
  if (status_ != Status::kAmbiguous) return false;
  return hypotheses_.leastError() < kWell && shareOf(T_map_base_by_odometry) < kRuledOut &&
         shareOf(T_map_base) > kLikely;
}

Pose2 Recovery::published(const Pose2& T_map_base_by_odometry, const Estimate& estimate) const {
  if (isCorrection(T_map_base_by_odometry, estimate.T_map_base)) return estimate.T_map_base;
  const Mode* held = heldPlace(T_map_base_by_odometry);
  return held ? held->T_map_base : T_map_base_by_odometry;
}

double Recovery::confidence(const Pose2& T_map_base, const Pose2& T_map_base_of_core) const {
  if (is_settled_ && !areSamePlace(T_map_base, T_map_base_of_core)) return 0.0;
  const bool is_proven = proof_.isEnoughForTheMap() && !proof_.isSuspect();
  const double most = is_proven ? 1.0 : kUnproven;
  const double belief = std::min(most, confidence_.value() * shareOf(T_map_base));
  if (confidence_.isContradicted()) return belief;  // by another sense
  switch (status()) {
    case Status::kTracking:
      return shareOfRightTracks(belief);
    case Status::kAmbiguous:
      return shareOfRightPlaces(belief, proof_.isByScans());
    default:
      return std::min(kLost, belief);
  }
}

}  // namespace adaptive_localization
