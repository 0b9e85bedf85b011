// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/toy_world.hpp"

namespace adaptive_localization {

/// A room of 4 m by 3 m, its walls in the cells that are `from` to before `to` cells behind it.
inline std::shared_ptr<const OccupancyGrid> roomWithWalls(int from, int to) {
  constexpr int kWidth = 80, kHeight = 60;  // cells
  const int margin = std::max(10, to + 3);
  const Lattice lattice(kWidth + 2 * margin, kHeight + 2 * margin, 0.05,
                        {0.05 * (10 - margin), 0.05 * (10 - margin), 0.0});
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kFree);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = lattice.cell(i);
    const int beyond_x = std::max(margin - 1 - cell.x, cell.x - margin - kWidth);
    const int beyond_y = std::max(margin - 1 - cell.y, cell.y - margin - kHeight);
    const int behind = std::max(beyond_x, beyond_y);
    if (behind >= from && behind < to) cells[i] = OccupancyGrid::kOccupied;
  }
  return std::make_shared<const OccupancyGrid>(lattice, std::move(cells));
}

}  // namespace adaptive_localization
