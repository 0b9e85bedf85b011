// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>

#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "localizer/scan_change.hpp"

namespace adaptive_localization {

/// What is to be seen from one scan to the next, whatever the map: asked of every scan, whether it
/// makes an update or not.
class ScanWatch {
 public:
  /// Takes note of a scan, and of where base is by the odometry.
  void observe(const Pose2& T_odom_base, const Scan& scan);

  /// The robot was carried away since this was told last.
  bool sawCarrying() const { return is_carried_; }
  bool tellCarrying() { return std::exchange(is_carried_, false); }

  /// Much came near at once since scans fitted the core's place, or since a search ended.
  bool hasComeNear() const { return came_near_; }
  void forgetNear() { came_near_ = false; }

  /// The robot did not move since the scan before.
  bool isAtRest() const { return is_at_rest_; }

  /// The laser is covered, and was not by the scan before.
  bool isJustCovered() const { return is_covered_ && !was_covered_; }

  /// A scan fits the core's place, so far on from the last update.
  void fit(const Pose2& motion);

  /// The last scan may be of another place than the one before, by what is known besides.
  void breakOff();

  /// Scans have fitted on enough of the way, and each since then has shown what the one before did:
  /// nobody carried the robot.
  bool goesOn() const;

 private:
  ScanChange change_;
  std::optional<Pose2> T_odom_base_;             // at the last scan
  bool is_covered_{false}, was_covered_{false};  // the laser of the last scan, of the one before
  bool is_at_rest_{false};
  bool is_carried_{false};
  bool came_near_{false};
  bool is_changed_{true};  // since the last scan that fits, or none was observed
  double way_on_{0.0};     // m or rad, of fitting scans that each show what the one before did
};

}  // namespace adaptive_localization
