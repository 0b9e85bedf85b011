// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// A hand before the laser, or somebody who stands there, looks like a corner of the map somewhere:
/// a scan that sees hardly anything beyond arm's length is no evidence.
inline bool isCovered(const Scan& scan) {
  constexpr double kArm = 0.6;    // m
  constexpr double kShare = 0.1;  // of the beams
  const Eigen::Index far =
      (scan.range > static_cast<float>(kArm)).count() + scan.no_return_bearing.size();
  const Eigen::Index beams = scan.range.size() + scan.no_return_bearing.size();
  return scan.hits() == 0 || static_cast<double>(far) < kShare * static_cast<double>(beams);
}

}  // namespace adaptive_localization
