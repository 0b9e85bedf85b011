// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Notices a robot that is carried away by what its laser sees, whatever the map: from one scan to
/// the next half of it changes though the odometry says that the robot hardly moved. A map that is
/// old or poor does not matter, since both scans are of the same walls.
///
/// A beam has changed if no point of the scan before, moved by the odometry, lies within 2 degrees
/// of it as far off. Wheels that slip in a turn are no carrying: both scans may be turned against
/// each other by up to 15 degrees. Nor are people, before whom beams become shorter, or longer when
/// they step aside: of a change of place some do either.
class ScanChange {
 public:
  /// Takes note of a scan, and of where base is by the odometry. Whether it shows another place
  /// than the scan before of the same laser. A laser that is covered shows none.
  bool isElsewhere(const Pose2& T_odom_base, const Scan& scan);

  void forget() { seen_.clear(); }

 private:
  /// What a laser saw last.
  struct Seen {
    Pose2 T_odom_base;
    Scan scan;
  };

  std::vector<Seen> seen_;
};

}  // namespace adaptive_localization
