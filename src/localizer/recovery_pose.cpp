// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "localizer/recovery.hpp"
#include "ser/place.hpp"

namespace adaptive_localization {

/// The place that a pose is in while several are possible, if it is about as likely as any.
const Mode* Recovery::heldPlace(const Pose2& T_map_base) const {
  constexpr double kFair = 0.3;  // mass
  const Mode* mode = status_ == Status::kAmbiguous ? modeAt(T_map_base, modes_) : nullptr;
  return mode && mode->mass > std::min(kFair, 0.5 * modes_.front().mass) ? mode : nullptr;
}

/// A robot that was known to be somewhere is there, as the core has it, until that place is ruled
/// out and another one, that explains the scan well, is likelier than all others: what a core makes
/// of a blocked laser is no reason to jump. One that was not stays in one of the likely places; so
/// does one that left such a place some way ago, if the core is in one.
bool Recovery::isCorrection(const Pose2& T_map_base_by_odometry, const Pose2& T_map_base) const {
  constexpr double kRuledOut = 0.05, kLikely = 0.97, kWell = 0.1;  // mass, mass, m
  constexpr double kFarFromIt = 3.0;                               // m, of way
  if (status_ == Status::kTracking || areSamePlace(T_map_base_by_odometry, T_map_base)) return true;
  if (status_ == Status::kAmbiguous && is_settled_ && !proof_.isGiven()) return true;
  if (!was_tracking_) return !heldPlace(T_map_base_by_odometry);
  if (left_way_ > kFarFromIt && heldPlace(T_map_base)) return !heldPlace(T_map_base_by_odometry);
  if (status_ != Status::kAmbiguous) return false;
  return hypotheses_.leastError() < kWell && shareOf(T_map_base_by_odometry) < kRuledOut &&
         shareOf(T_map_base) > kLikely;
}

Pose2 Recovery::published(const Pose2& T_map_base_by_odometry, const Estimate& estimate) const {
  if (isCorrection(T_map_base_by_odometry, estimate.T_map_base)) return estimate.T_map_base;
  const Mode* held = heldPlace(T_map_base_by_odometry);
  return held ? held->T_map_base : T_map_base_by_odometry;
}

}  // namespace adaptive_localization
