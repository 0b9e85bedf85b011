// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Notices by what its laser sees that a robot is carried away, whatever the map: a scan changes
/// though the odometry says that the robot hardly moved. A map that is old or poor does not matter,
/// since both scans are of the same walls.
///
/// A beam is shorter or longer than before if no point of the scan before, moved by the odometry,
/// lies within 2 degrees of it about as far off. With the shares s and l of the beams that are, the
/// place is another one if
///
///     s + l + 2 min(s, l) > 0.7   and   min(s, l) > 0.05
///
/// People make beams shorter, or longer when they step aside; a change of place does either. Wheels
/// that slip in a turn are none: it has to hold for the scans turned against each other by up to 15
/// degrees. The bounds were chosen by recorded scans (doc/how_it_works.md).
class ScanChange {
 public:
  /// Takes note of a scan, and of where base is by the odometry. Whether it shows another place
  /// than the scan before of the same laser. A laser that is covered shows none.
  bool isElsewhere(const Pose2& T_odom_base, const Scan& scan);

  /// Of the last scan's beams that can be compared with the scan before, the share that are shorter
  /// or longer; 1 where they cannot be.
  double changedShare() const { return changed_share_; }

  /// The share that are shorter; 0 where they cannot be compared.
  double nearerShare() const { return nearer_share_; }

  void forget() { seen_.clear(); }

 private:
  /// What a laser saw last.
  struct Seen {
    Pose2 T_odom_base;
    Scan scan;
  };

  bool isOtherPlace(const Scan& before, const Pose2& motion, const Scan& now);

  std::vector<Seen> seen_;
  double changed_share_{1.0}, nearer_share_{0.0};
};

}  // namespace adaptive_localization
