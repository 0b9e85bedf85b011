// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/map/ray_caster.hpp"

namespace adaptive_localization {

/// How badly a scan fits a pose, for all who ask. With z_i the ranges read, z_i* those expected at
/// the pose by ray casting, and c the truncation,
///
///     e(pose) = (1 / I) sum_i min(|z_i* - z_i|, c)
///
/// A no-return counts as the largest range. Of scans with many beams every n-th is looked at.
class RangeError {
 public:
  static constexpr double kTruncation = 0.5;  // m; an error beyond tells no more

  struct Fit {
    double error{kTruncation};  // mean per beam, m; the truncation for a scan without beams
    double short_share{0.0};    // of the beams: too short by 0.25 m and more
  };

  explicit RangeError(std::shared_ptr<const OccupancyGrid> map, double truncation = kTruncation)
      : ray_caster_(std::move(map)), truncation_(truncation) {}

  /// Ranges, read and expected, are cut off at max_range, m.
  Fit at(const Pose2& T_map_base, const Scan& scan, double max_range) const;
  Fit at(const Pose2& T_map_base, const Scan& scan) const {
    return at(T_map_base, scan, scan.max_range);
  }

 private:
  RayCaster ray_caster_;
  double truncation_;
};

}  // namespace adaptive_localization
