// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "adaptive_localization/core/stop_token.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"
#include "ser/const_array.hpp"
#include "ser/scan_energy.hpp"

namespace adaptive_localization {

class RangeBlocks;

/// Told how many of the kDirections are done, by who makes a table for a large map.
using SweepProgress = std::function<void(std::size_t)>;

/// Expected ranges from the centre of each free cell in each direction, one byte each: what would
/// be ray casting, looked up.
///
/// Made by sweeping each direction once over the whole map: the digital line through a cell's
/// neighbour goes on where its own does, so that range(cell) = range(neighbour) + step unless there
/// is an obstacle in between. O(directions x cells), whatever the range. Lines cross cells side by
/// side (never corner to corner), so they do not slip through walls that are one cell thin and
/// slanted. Unknown cells are transparent, as in RayCaster.
class RangeTable {
 public:
  /// Every `spacing`-th cell of the map in x and y. Throws std::invalid_argument if the map has no
  /// free cell, and Stopped.
  RangeTable(const OccupancyGrid& map, double max_range, int spacing = 1,
             const StopToken& stop = {}, const SweepProgress& progress = {});

  const Lattice& lattice() const { return lattice_; }  // of the map
  double maxRange() const { return max_range_; }
  double metresPerStep() const { return max_range_ / kNoReturn; }
  int spacing() const { return spacing_; }

  /// Number of cells with ranges.
  std::size_t size() const { return cells_.size(); }
  Cell cell(std::size_t i) const { return lattice_.cell(cells_[i]); }
  Eigen::Vector2d centre(std::size_t i) const { return lattice_.centre(cell(i)); }

  /// kDirections ranges in steps; direction d is d * kDirectionStep from the lattice's x axis.
  const std::uint8_t* ranges(std::size_t i) const { return ranges_.data() + i * kRangeStride; }

  /// What can be seen from blocks of cells, for searching.
  const RangeBlocks& blocks() const { return *blocks_; }

  /// Bytes of memory.
  std::size_t bytes() const;

 private:
  friend class GridCache;
  explicit RangeTable(const Lattice& lattice) : lattice_(lattice) {}

  Lattice lattice_;
  double max_range_{0.0};
  int spacing_{1};
  ConstArray<std::uint32_t> cells_;  // indices of the lattice, ascending
  ConstArray<std::uint8_t> ranges_;
  std::shared_ptr<const RangeBlocks> blocks_;
};

}  // namespace adaptive_localization
