// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/stop_token.hpp"
#include "adaptive_localization/map/map_quality.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"
#include "adaptive_localization/map/sparse_grid.hpp"

namespace adaptive_localization {

struct NearnessView;

/// Euclidean distance from each cell's centre to the centre of the nearest cell of a wall, exact
/// (OpenCV's precise transform, Felzenszwalb and Huttenlocher 2012). Walls are the occupied cells
/// down to kWallDepth below their faces: where a map was made inexactly they are thick, and a laser
/// sees what is in their middle. Deeper is no wall: all of a scan would fit into the rock around a
/// small room. Nor are isolated cells of a map with speckle.
///
/// Distances end at a reach of 5 m, or of 16 cells where that is more, or 1023 where that is less:
/// what is farther from any wall, or outside the map, is at the reach and takes no memory. Steps of
/// 1/64 cell, two bytes per cell within reach.
class DistanceField {
 public:
  /// Throws Stopped.
  explicit DistanceField(const OccupancyGrid& grid, const StopToken& stop = {});

  /// The same, of a grid that differs in patches alone from the one that a field was made of: only
  /// what is within reach of these is made anew. Throws Stopped.
  DistanceField(const OccupancyGrid& grid, const DistanceField& before,
                const std::vector<MapPatch>& patches, const StopToken& stop = {});

  const Lattice& lattice() const { return lattice_; }
  double reach() const { return step_ * reach_; }  // m

  /// Metres.
  double at(const Cell& cell) const {
    return step_ * (lattice_.contains(cell) ? stepsTo(cell) : reach_);
  }
  double at(const Eigen::Vector2d& point_map) const { return at(lattice_.cellAt(point_map)); }

  /// The same, as cells; the cell must be on the lattice.
  double cellsTo(const Cell& cell) const { return stepsTo(cell) * (1.0 / kStepsPerCell); }

  /// The same, as steps.
  int stepsTo(const Cell& cell) const { return reach_ - nearness_.at(cell.x + 1, cell.y + 1); }
  double metresPerStep() const { return step_; }

  /// Metres between the four centres around a point, so that it does not jump where cells meet.
  double between(const Eigen::Vector2d& point_map) const;

  /// The sum of min(between(p), most), m, over every stride-th of some points in the frame of a
  /// base at a pose.
  double sumBetween(const Pose2& T_map_base, const Eigen::ArrayXf& x, const Eigen::ArrayXf& y,
                    Eigen::Index stride, double most) const;

  /// Of the map that it was made from.
  const MapQuality& quality() const { return quality_; }

  /// How many steps nearer than the reach each cell is, with a border of one cell that is not.
  const SparseGrid& nearness() const { return nearness_; }
  int reachInSteps() const { return reach_; }

 private:
  static constexpr int kStepsPerCell = 64;

  NearnessView view() const;

  Lattice lattice_;
  double step_;
  int reach_;         // steps
  bool has_speckle_;  // the map
  MapQuality quality_;
  SparseGrid nearness_;
};

}  // namespace adaptive_localization
