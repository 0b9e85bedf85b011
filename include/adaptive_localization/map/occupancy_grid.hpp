// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "adaptive_localization/map/lattice.hpp"

namespace adaptive_localization {

/// New values for a rectangle of a map's cells, as map_msgs/OccupancyGridUpdate has them.
struct MapPatch {
  Cell corner;  // the first of its cells in the map
  int width;
  int height;
  std::vector<std::int8_t> cells;  // row-major, from the corner on
};

/// An occupancy grid with nav_msgs/OccupancyGrid's values: 0 to 100 in per cent, -1 unknown.
/// Cells of at least 65 are occupied and known ones below 20 free, map_server's thresholds, so that
/// grids with graded values (Cartographer's, map_server's scale mode) work too.
class OccupancyGrid {
 public:
  static constexpr std::int8_t kFree = 0;
  static constexpr std::int8_t kOccupied = 100;
  static constexpr std::int8_t kLeastOccupied = 65;
  static constexpr std::int8_t kUnknown = -1;

  /// Row-major cells, row 0 at the origin. Throws std::invalid_argument when their number is not
  /// the lattice's.
  OccupancyGrid(const Lattice& lattice, std::vector<std::int8_t> cells);

  /// The same with the cells of patches, later ones over earlier ones. Throws std::invalid_argument
  /// where checkFits() does.
  OccupancyGrid with(const std::vector<MapPatch>& patches) const;

  const Lattice& lattice() const { return lattice_; }
  const std::vector<std::int8_t>& cells() const { return cells_; }

  bool isOccupied(const Cell& cell) const { return at(cell) >= kLeastOccupied; }
  bool isFree(const Cell& cell) const { return at(cell) >= 0 && at(cell) < 20; }

  /// Whether beams end at a cell: at occupied ones, but not at the isolated ones of a map with
  /// speckle.
  bool endsBeams(const Cell& cell) const {
    return isOccupied(cell) && !(has_speckle_ && occupiedAround(cell) == 1);
  }

  /// Whether occupied cells are strewn over the map that stand for nothing: many are isolated, and
  /// hardly any come in pairs, as noise does. What a robot mapped that is gone, people and legs of
  /// chairs, comes in clusters.
  bool hasSpeckle() const { return has_speckle_; }

  /// How far a cell is, along x or y, from those that tell whether it is isolated.
  static constexpr int kSpeckleReach = 2;

  std::size_t countFree() const;

 private:
  /// Occupied cells within two cells, itself too; 3 stands for more.
  int occupiedAround(const Cell& cell) const;
  bool looksSpeckled() const;

  /// Cells outside are unknown.
  std::int8_t at(const Cell& cell) const {
    return lattice_.contains(cell) ? cells_[lattice_.index(cell)] : kUnknown;
  }

  Lattice lattice_;
  std::vector<std::int8_t> cells_;
  bool has_speckle_;
};

/// Throws std::invalid_argument unless a patch has as many cells as its size says, at least one,
/// all of them on the lattice.
void checkFits(const MapPatch& patch, const Lattice& lattice);

}  // namespace adaptive_localization
