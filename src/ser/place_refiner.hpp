// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>

#include "adaptive_localization/map/distance_field.hpp"
#include "map/range_error.hpp"
#include "ser/place.hpp"
#include "ser/scan_energy.hpp"

namespace adaptive_localization {

/// Moves a pose to where the scan fits the map best nearby, and judges it by exact ranges.
class PlaceRefiner {
 public:
  PlaceRefiner(std::shared_ptr<const OccupancyGrid> map, std::shared_ptr<const DistanceField> field,
               const Scan& scan, double max_range, double truncation);

  /// Pattern search (Hooke and Jeeves 1961) for the least sum of min(d, truncation) over hits, d
  /// the distance to the nearest obstacle, to a centimetre and a quarter of a degree.
  Place refine(const Pose2& T_map_base) const;

  /// The same to a quarter of that, for a place that is followed: where it stays one, by ranges,
  /// and else where it is. Hits can be drawn to the far side of a thin wall: ranges tell. It is
  /// held by a spring: a move of 0.1 m or 0.05 rad costs as much as hits that are 0.2 m off in all,
  /// and moves their squares. Where the scan does not fix the pose, as along a wall, it stays.
  Place align(const Pose2& T_map_base) const;

  /// The same to some centimetres, judged by that sum alone, m: at a quarter of the cost.
  Place approach(const Pose2& T_map_base) const;

  /// Of ranges, truncated, both cut off at max_range.
  RangeError::Fit fit(const Pose2& T_map_base) const {
    return range_error_.at(T_map_base, scan_, max_range_);
  }

  /// Share of the hits that are nearer to obstacles than this, whatever stands before them.
  double hitShare(const Pose2& T_map_base, double distance) const;

  /// The error of a place shared out to the hits alone, m: where most beams see nothing and agree
  /// with a map of the open, the mean of all says little.
  double errorPerHit(const Place& place) const {
    const auto beams = static_cast<double>(scan_.hits() + scan_.no_return_bearing.size());
    return place.error * beams / std::max(1, scan_.hits());
  }

  /// Of the scan.
  int hits() const { return scan_.hits(); }

  /// Of the scan, from its first beam to its last, rad.
  double view() const { return scan_.view.width; }

  /// The mean range error.
  double error(const Pose2& T_map_base) const { return fit(T_map_base).error; }

 private:
  double misfit(const Pose2& T_map_base) const;
  Pose2 descend(const Pose2& T_map_base, double stiffness, double least_step) const;

  RangeError range_error_;
  std::shared_ptr<const DistanceField> field_;
  const Scan& scan_;
  double max_range_;
  double truncation_;
};

}  // namespace adaptive_localization
