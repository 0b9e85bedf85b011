// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// A box of the map as sweeps read it: lines of cells, u the number of a line and v the place on
/// it. Ranges are asked for from its free cells in every `spacing`-th row and column of the map.
class SweepMap {
 public:
  /// Lines are the box's columns (u = x, v = y) or its rows (u = y, v = x).
  SweepMap(const OccupancyGrid& map, const CellBox& box, bool lines_are_columns, int spacing);

  int lines() const { return lines_; }
  int length() const { return length_; }  // of a line
  bool isAskedFor(int u) const { return u % spacing_ == first_u_; }
  int askedBefore(int u) const { return (u - first_u_ + spacing_ - 1) / spacing_; }  // lines

  /// 1 where a beam ends, else 0; with one 0 more before and after.
  const std::uint8_t* obstacles(int u) const { return obstacles_.data() + at(u, length_ + 2) + 1; }

  /// The same with a bit for each cell, 64 to a word, and with obstacles beyond the end; and the
  /// cells that are asked for.
  int words() const { return words_; }  // to a line
  const std::uint64_t* obstacleBits(int u) const { return obstacle_bits_.data() + at(u, words_); }
  const std::uint64_t* askedBits(int u) const { return asked_bits_.data() + at(u, words_); }

 private:
  static std::size_t at(int u, int pitch) {
    return static_cast<std::size_t>(u) * static_cast<std::size_t>(pitch);
  }

  int lines_, length_, words_;
  int spacing_, first_u_;
  std::vector<std::uint8_t> obstacles_;
  std::vector<std::uint64_t> obstacle_bits_, asked_bits_;
};

}  // namespace adaptive_localization
