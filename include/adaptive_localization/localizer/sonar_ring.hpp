// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "adaptive_localization/core/observations.hpp"

namespace adaptive_localization {

/// Sonars ping one after the other, so it takes some scans until all were heard. Keeps the newest
/// reading of each until an update has used it, and moves it along with the odometry.
class SonarRing {
 public:
  /// Takes note of what was heard, from base at a pose.
  void hear(const Pose2& T_odom_base, const Observations& observations);

  /// All that is kept, from base at a pose.
  std::vector<SonarReading> readingsFrom(const Pose2& T_odom_base) const;

  void forget() { kept_.clear(); }

 private:
  struct Kept {
    double stamp;  // s
    Pose2 T_odom_sonar;
    SonarReading reading;
  };

  std::map<int, Kept> kept_;  // by the sonar
};

}  // namespace adaptive_localization
