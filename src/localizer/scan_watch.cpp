// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/scan_watch.hpp"

#include "kept_place.hpp"
#include "occlusion.hpp"

namespace adaptive_localization {

void ScanWatch::observe(const Pose2& T_odom_base, const Scan& scan) {
  constexpr double kNoWay = 0.005;       // m or rad
  constexpr double kMostChanged = 0.35;  // of the beams, unless people pass close by
  constexpr double kMuch = 0.35;         // likewise
  is_at_rest_ = T_odom_base_ && wayOf(between(*T_odom_base_, T_odom_base)) < kNoWay;
  T_odom_base_ = T_odom_base;
  was_covered_ = std::exchange(is_covered_, isCovered(scan));
  is_carried_ = change_.isElsewhere(T_odom_base, scan) || is_carried_;
  if (change_.changedShare() > kMostChanged) breakOff();
  const bool sees_much = scan.view.width > kMostOfView;  // else one thing may be all
  came_near_ = came_near_ || (sees_much && change_.nearerShare() > kMuch);
}

void ScanWatch::breakOff() {
  way_on_ = 0.0;
  is_changed_ = true;
}

/// On the way to a scan after a change the robot may have been carried, and so it may where no scan
/// was observed at all.
void ScanWatch::fit(const Pose2& motion) {
  way_on_ += is_changed_ ? 0.0 : wayOf(motion);
  is_changed_ = !T_odom_base_;
}

bool ScanWatch::goesOn() const {
  constexpr double kWayOn = 0.5;  // m or rad
  return way_on_ >= kWayOn;
}

}  // namespace adaptive_localization
