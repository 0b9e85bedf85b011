// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "adaptive_localization/core/stop_token.hpp"
#include "adaptive_localization/map/map_quality.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// Euclidean distance from each cell's centre to the centre of the nearest cell of a wall, exact
/// (OpenCV's precise transform, Felzenszwalb and Huttenlocher 2012). Walls are the occupied cells
/// down to kWallDepth below their faces: where a map was made inexactly they are thick, and a laser
/// sees what is in their middle. Deeper is no wall: all of a scan would fit into the rock around a
/// small room. Two bytes per cell: steps of 1/64 cell, saturating at 1023 cells; a map without
/// obstacles is saturated everywhere.
class DistanceField {
 public:
  /// Throws Stopped.
  explicit DistanceField(const OccupancyGrid& grid, const StopToken& stop = {});

  const Lattice& lattice() const { return lattice_; }

  /// Metres; the saturation distance outside the map.
  double at(const Cell& cell) const {
    return step_ * (lattice_.contains(cell) ? steps_[lattice_.index(cell)] : kFar);
  }
  double at(const Eigen::Vector2d& point_map) const { return at(lattice_.cellAt(point_map)); }

  /// The same, as cells; the cell must be on the lattice.
  double cellsTo(const Cell& cell) const {
    return steps_[lattice_.index(cell)] * (1.0 / kStepsPerCell);
  }

  /// Metres between the four centres around a point, so that it does not jump where cells meet.
  double between(const Eigen::Vector2d& point_map) const;

  /// The sum of min(between(p), most), m, over every stride-th of some points in the frame of a
  /// base at a pose.
  double sumBetween(const Pose2& T_map_base, const Eigen::ArrayXf& x, const Eigen::ArrayXf& y,
                    Eigen::Index stride, double most) const;

  /// Of the map that it was made from.
  const MapQuality& quality() const { return quality_; }

  /// The stored steps, row-major, and how many metres one is.
  const std::vector<std::uint16_t>& steps() const { return steps_; }
  double metresPerStep() const { return step_; }

 private:
  static constexpr int kStepsPerCell = 64;
  static constexpr std::uint16_t kFar = 65535;

  double stepsBetween(double x, double y) const;

  Lattice lattice_;
  double step_;
  MapQuality quality_;
  std::vector<std::uint16_t> steps_;
};

}  // namespace adaptive_localization
