// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "map/polygon.hpp"
#include "match/surface.hpp"

namespace adaptive_localization {

/// The surface nearest to any point, by look-up: labels for each cell of the map.
///
/// From an occupancy grid: a line is fitted to the cells around each occupied one that free ground
/// touches on the same side (total least squares, weights falling with distance), which tells where
/// the wall is to a fraction of a cell if it is straight; where the cells around make no line there
/// is no surface. From line segments: the segments. Labels reach so far beyond a surface, m; they
/// are kept in tiles, and only in those where there are any.
class SurfaceMap {
 public:
  explicit SurfaceMap(const OccupancyGrid& grid, double reach = 2.0);

  /// Segments with the free side on the left of a -> b, looked up in the cells of a lattice;
  /// those of no length are left out.
  SurfaceMap(const Lattice& lattice, const std::vector<Segment>& segments, double reach = 2.0);

  const Lattice& lattice() const { return lattice_; }

  /// The surface that a beam from `start` hit at a point: of those that face the start the nearest,
  /// which is the near side of a wall wherever noise puts the hit. Null where there is none
  /// within reach, outside the lattice, and where all face away.
  const Surface* hitBy(const Eigen::Vector2d& start, const Eigen::Vector2d& hit) const;

  /// All of them.
  const std::vector<Surface>& surfaces() const { return surfaces_; }

 private:
  /// A surface and the cell that it is in.
  struct Seed {
    Cell cell;
    std::uint32_t surface;
  };
  static constexpr std::size_t kLayers = 4;
  static constexpr int kTile = 32;  // cells

  /// Of each cell, row-major, the nearest of the surfaces that look to +x, -x, +y and -y, as
  /// numbers in a list of the tile's own; kNone: none does within reach. No labels: none anywhere.
  struct Tile {
    std::vector<std::uint32_t> surfaces;
    std::vector<std::uint16_t> labels;
  };
  static constexpr std::uint16_t kNone = 0xFFFF;

  class Group;

  void spread(const std::vector<Seed>& seeds, double reach);
  std::size_t tileOf(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y / kTile) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cell.x / kTile);
  }
  static std::size_t placeInTile(const Cell& cell) {
    return kLayers * static_cast<std::size_t>(cell.y % kTile * kTile + cell.x % kTile);
  }

  Lattice lattice_;
  std::vector<Surface> surfaces_;
  int columns_{0}, rows_{0};  // of tiles
  std::vector<Tile> tiles_;
};

}  // namespace adaptive_localization
