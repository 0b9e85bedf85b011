// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "adaptive_localization/map/lattice.hpp"

namespace adaptive_localization {

/// A rectangle of a map's cells.
struct CellBox {
  int x{0}, y{0};  // of its first cell
  int width{0}, height{0};

  bool contains(const Cell& cell) const {
    return cell.x >= x && cell.x < x + width && cell.y >= y && cell.y < y + height;
  }
  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// Row-major index of a cell that it contains.
  std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y - y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(cell.x - x);
  }
  Cell cell(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(width);
    return {x + static_cast<int>(index % columns), y + static_cast<int>(index / columns)};
  }
};

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
///
/// Only the smallest box around all known cells is stored: maps as mapping programs write them are
/// unknown for the most part.
class OccupancyGrid {
 public:
  static constexpr std::int8_t kFree = 0;
  static constexpr std::int8_t kOccupied = 100;
  static constexpr std::int8_t kLeastOccupied = 65;
  static constexpr std::int8_t kUnknown = -1;

  /// Row-major cells, row 0 at the origin. Throws std::invalid_argument when their number is not
  /// the lattice's.
  OccupancyGrid(const Lattice& lattice, const std::vector<std::int8_t>& cells);

  /// Gives all cells of a row, which may be gone when it is asked for the next one. Row 0 is at the
  /// origin. Asked twice for some rows.
  using Rows = std::function<const std::int8_t*(int row)>;
  static OccupancyGrid fromRows(const Lattice& lattice, const Rows& rows);

  /// The same with the cells of patches, later ones over earlier ones. Throws std::invalid_argument
  /// where checkFits() does.
  OccupancyGrid with(const std::vector<MapPatch>& patches) const;

  const Lattice& lattice() const { return lattice_; }

  /// A copy of all cells, row-major.
  std::vector<std::int8_t> cells() const;

  /// The smallest box around all known cells, and its cells, row-major. Empty if there is none.
  const CellBox& known() const { return known_; }
  const std::vector<std::int8_t>& knownCells() const { return known_cells_; }

  /// Cells outside are unknown.
  std::int8_t at(const Cell& cell) const {
    return known_.contains(cell) ? known_cells_[known_.index(cell)] : kUnknown;
  }
  bool isOccupied(const Cell& cell) const { return at(cell) >= kLeastOccupied; }
  bool isFree(const Cell& cell) const { return at(cell) >= 0 && at(cell) < 20; }

  /// Whether beams end at a cell: at occupied ones, but on a map with speckle not at those that are
  /// isolated or come in pairs, as fine cells that noise strews do by chance.
  bool endsBeams(const Cell& cell) const {
    return isOccupied(cell) && !(has_speckle_ && occupiedAround(cell) < kMany);
  }

  /// Whether occupied cells are strewn over the map that stand for nothing: many are isolated, and
  /// hardly any come in pairs, as noise does. What a robot mapped that is gone, people and legs of
  /// chairs, comes in clusters.
  bool hasSpeckle() const { return has_speckle_; }

  /// How far a cell is, along x or y, from those that tell whether it is isolated.
  static constexpr int kSpeckleReach = 2;

  std::size_t countFree() const;
  std::size_t countKnown() const;

 private:
  /// Without known cells.
  explicit OccupancyGrid(const Lattice& lattice) : lattice_(lattice) {}

  /// Takes what is known of a box, whose rows are numbered from 0 on.
  void store(const CellBox& box, const Rows& rows);

  static constexpr int kMany = 3;

  /// Occupied cells within two cells, itself too; kMany stands for more.
  int occupiedAround(const Cell& cell) const;
  bool looksSpeckled() const;

  Lattice lattice_;
  CellBox known_;
  std::vector<std::int8_t> known_cells_;
  bool has_speckle_{false};
};

/// Throws std::invalid_argument unless a patch has as many cells as its size says, at least one,
/// all of them on the lattice.
void checkFits(const MapPatch& patch, const Lattice& lattice);

}  // namespace adaptive_localization
