// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/doubt.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {

void Doubt::raise(const Pose2& T_map_base, const TrackingOdds& odds) {
  if (followed_.isEmpty()) followed_.addKept(T_map_base, odds);
  T_map_base_ = T_map_base;
  T_map_base_ = byScans();
  way_ = turn_ = 0.0;
}

void Doubt::keep(const Pose2& T_map_base, const TrackingOdds& odds) {
  followed_.clear();
  followed_.addKept(T_map_base, odds);
}

void Doubt::ride(const Pose2& motion) {
  followed_.ride(motion);
  if (T_map_base_) T_map_base_ = *T_map_base_ * motion;
  way_ += std::hypot(motion.x, motion.y);
  turn_ += std::abs(motion.theta);
}

void Doubt::count(bool fits) {
  scans_ = isRaised() ? scans_ + 1 : 0;
  misfits_ = (isRaised() ? misfits_ : 0) + (fits ? 0 : 1);
}

void Doubt::follow(const Pose2& T_map_core, const Scan& scan, double usual_error) {
  if (followed_.isEmpty() || scan.hits() == 0) return;
  followed_.note(T_map_core);
  followed_.follow(scan, usual_error);
}

bool Doubt::isBrief() const {
  constexpr double kWay = 0.5;  // m and rad together
  constexpr int kScans = 10;
  return scans_ < kScans && way_ + turn_ < kWay;
}

bool Doubt::hasSlid(const Pose2& T_map_core) const {
  constexpr int kMisfits = 2;
  constexpr double kMoved = 0.3, kTurned = 0.25;                           // m, rad
  constexpr double kPerWay = 0.15, kBesidePerTurn = 0.1, kPerTurn = 0.25;  // of odometry
  if (!isRaised() || misfits_ < kMisfits) return false;
  const Pose2 slid = between(*T_map_base_, T_map_core);
  const double beside = kPerWay * way_ + kBesidePerTurn * turn_;  // m
  return std::hypot(slid.x, slid.y) > std::max(kMoved, beside) ||
         std::abs(slid.theta) > std::max(kTurned, kPerTurn * turn_);
}

}  // namespace adaptive_localization
