// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>

#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// Expected ranges by exact traversal of the grid (Amanatides and Woo, Eurographics 1987): every
/// cell that the ray crosses is looked at once, so no corner is missed. With the map's distance
/// field the ray goes on at once by as much as no wall is nearer: the same ranges in less
/// time.
class RayCaster {
 public:
  explicit RayCaster(std::shared_ptr<const OccupancyGrid> grid,
                     std::shared_ptr<const DistanceField> field = nullptr)
      : grid_(std::move(grid)), field_(std::move(field)) {}

  /// Metres from the ray's start (map frame, theta its direction) to the surface in the first cell
  /// that beams end at; max_range if there is none before. Surfaces pass through the middle of
  /// cells, since maps mark those in which beams ended: half a cell along x or y, whichever the ray
  /// runs along, behind the side by which it enters. Unknown cells, speckle and everything
  /// outside the map are transparent.
  double range(const Pose2& T_map_ray, double max_range) const {
    return wall(T_map_ray, max_range, 0.0).near;
  }

  /// Where along a ray the wall is that it meets first, m: the middles of its first cell and of the
  /// last one before the ray leaves it, or comes `depth` deep, or the first that is as far as
  /// `until`.
  struct Wall {
    double near, far;
  };
  Wall wall(const Pose2& T_map_ray, double max_range, double depth,
            double until = std::numeric_limits<double>::infinity()) const;

 private:
  std::shared_ptr<const OccupancyGrid> grid_;
  std::shared_ptr<const DistanceField> field_;  // null: walls are met cell by cell
};

}  // namespace adaptive_localization
