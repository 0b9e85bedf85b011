// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "adaptive_localization/core/stop_token.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// A rectangle of a map's cells.
struct CellBox {
  int x, y;  // of its first cell
  int width, height;
};

/// The smallest box around all known cells; empty if there is none.
CellBox knownCells(const OccupancyGrid& map);

/// A box of the map as sweeps read it: lines of cells along v, one for each u, with a border of one
/// free cell at both ends.
struct SweepMap {
  int lines;                           // number of u
  int length;                          // number of v
  std::vector<std::uint8_t> obstacle;  // [line][1 + v]: 1 where there is one, else 0

  const std::uint8_t* line(int u) const {
    return obstacle.data() + static_cast<std::size_t>(u) * static_cast<std::size_t>(length + 2) + 1;
  }
};

/// Lines are the box's columns (u = x, v = y) or its rows (u = y, v = x).
SweepMap sweepMapOf(const OccupancyGrid& map, const CellBox& box, bool lines_are_columns);

/// Ranges from all of a SweepMap's cells in one direction, which advances by `sense` (1 or -1) in u
/// and by `slope`, in [-1, 1], in v at each step: scale times the number of cells travelled until
/// half a step into the first obstacle (see RayCaster), rounded, at most 255. Only cells of every
/// `spacing`-th line and column are written, steps[u / spacing * pitch + v / spacing], counted from
/// `first`, the remainder of u and v.
struct Sweep {
  int sense;
  double slope;
  float scale;
  int spacing;
  int first_u, first_v;
  std::uint8_t* steps;
  std::size_t pitch;
};

/// Needs O(cells) time and two lines of memory. Throws Stopped.
void sweep(const SweepMap& map, const Sweep& request, const StopToken& stop = {});

}  // namespace adaptive_localization
