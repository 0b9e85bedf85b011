// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "adaptive_localization/core/observations.hpp"

namespace adaptive_localization {

/// Sources refuse what makes no sense; whoever calls a core may not.
inline bool isUsable(const SonarReading& reading) {
  constexpr double kMost = 1e3;  // m
  const Pose2& mount = reading.T_base_sonar;
  return reading.range >= 0.0 && reading.max_range > 0.0 && reading.max_range < kMost &&
         reading.view >= 0.0 && reading.view <= 2.0 * kPi && isFinite(mount) &&
         std::hypot(mount.x, mount.y) < kMost;
}

inline bool isEcho(const SonarReading& reading) {
  return reading.range < reading.max_range;
}

/// What a range adds to its standard deviation, m.
inline double shareOfRange(double range) {
  constexpr double kShare = 0.01;
  return kShare * range;
}

}  // namespace adaptive_localization
