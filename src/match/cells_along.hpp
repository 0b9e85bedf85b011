// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "adaptive_localization/map/lattice.hpp"
#include "map/polygon.hpp"

namespace adaptive_localization {

/// Calls action(Cell) for the lattice's cells that a segment runs through, every half a cell's
/// length.
template <class Action>
void forEachCellAlong(const Lattice& lattice, const Segment& segment, Action&& action) {
  const Eigen::Vector2d along = segment.b - segment.a;
  const int steps = static_cast<int>(std::ceil(2.0 * along.norm() / lattice.resolution()));
  for (int k = 0; k <= steps; ++k) {
    const Cell cell = lattice.cellAt(segment.a + along * (static_cast<double>(k) / steps));
    if (lattice.contains(cell)) action(cell);
  }
}

}  // namespace adaptive_localization
