// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/map/map_quality.hpp"
#include "map/ray_caster.hpp"

namespace adaptive_localization {

/// How badly a scan fits a pose, for all who ask. With z_i the ranges read, [a_i, b_i] where the
/// wall is that the beam is expected to meet, by ray casting, and c the truncation,
///
///     e(pose) = (1 / I) sum_i min(max(a_i - z_i, z_i - b_i, 0), c)
///
/// A beam may end anywhere in a wall, down to wall_depth below its face: maps that were made
/// inexactly have thick walls. A wall that the map has where the robot stands is looked through if
/// that explains a beam better. With a wall_depth of 0 it is the plain |z_i* - z_i|. A no-return
/// counts as the largest range. Of scans with many beams every n-th is looked at.
class RangeError {
 public:
  static constexpr double kTruncation = 0.5;  // m; an error beyond tells no more

  struct Fit {
    double error{kTruncation};  // mean per beam, m; the truncation for a scan without beams
    double short_share{0.0};    // of the beams: too short by 0.25 m and more
    double off_share{0.0};      // the same, too short or too long

    /// Of the beams, those that go on where the map has a wall.
    double throughShare() const { return off_share - short_share; }
  };

  explicit RangeError(std::shared_ptr<const OccupancyGrid> map,
                      std::shared_ptr<const DistanceField> field = nullptr,
                      double truncation = kTruncation, double wall_depth = kWallDepth)
      : ray_caster_(std::move(map), std::move(field)),
        truncation_(truncation),
        wall_depth_(wall_depth) {}

  /// Ranges, read and expected, are cut off at max_range, m.
  Fit at(const Pose2& T_map_base, const Scan& scan, double max_range) const;
  Fit at(const Pose2& T_map_base, const Scan& scan) const {
    return at(T_map_base, scan, scan.max_range);
  }

  /// By how much a hit is nearer than the wall that its beam is expected to meet, m; negative if it
  /// is farther.
  double missing(const Pose2& T_map_base, const Scan& scan, Eigen::Index hit) const;

 private:
  double missing(const Pose2& ray, double range, double max_range) const;

  RayCaster ray_caster_;
  double truncation_;
  double wall_depth_;
};

}  // namespace adaptive_localization
