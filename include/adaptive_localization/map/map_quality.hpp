// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// How far below its face a wall may be one, m: solid walls of plans end there, maps that were made
/// inexactly have hardly any that is deeper.
constexpr double kWallDepth = 0.35;

/// How well a map was made, by its looks: the errors that are to be expected before anything was
/// seen. Walls of scans that were laid over each other exactly are two cells deep, as a laser saw
/// their faces. Where scans were laid over each other inexactly, walls are deeper, a laser sees
/// what is anywhere in them, and their depth varies from place to place by as much as the scans
/// were off.
class MapQuality {
 public:
  explicit MapQuality(const OccupancyGrid& map);

  /// Mean depth of the walls, m, from the occupied cells and those of them at a face; 0 without
  /// any. Walls two cells deep and thinner count as two.
  double wallDepth() const { return wall_depth_; }

  /// Whether walls are deeper than those that a laser saw from their sides.
  bool hasThickWalls() const { return has_thick_walls_; }

  /// By how much the depth below a face varies along the middles of thick walls, m: its standard
  /// deviation within pieces of 2 m; 0 where walls are thin.
  double roughness() const { return roughness_; }

  /// Standard deviation of a hit from the wall it is of, m, of sensor and map together.
  double hitDeviation() const;

  /// The same from the middle of the wall it is of, where walls are thick as scans were laid over
  /// each other inexactly: half as much, as a beam may end anywhere in such a wall.
  double middleDeviation() const;

  /// Mean range error of a scan at the robot's place, m: half the depth of the walls, as far as
  /// that is more than the cell in which a beam ends.
  double rangeError() const;

 private:
  double resolution_;
  double wall_depth_;
  bool has_thick_walls_;
  double roughness_;
};

}  // namespace adaptive_localization
