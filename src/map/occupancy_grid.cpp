// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/occupancy_grid.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace adaptive_localization {

OccupancyGrid::OccupancyGrid(const Lattice& lattice, std::vector<std::int8_t> cells)
    : lattice_(lattice), cells_(std::move(cells)) {
  if (cells_.size() != lattice_.size()) {
    throw std::invalid_argument("map data: got " + std::to_string(cells_.size()) +
                                " cells, expected " + std::to_string(lattice_.size()));
  }
}

OccupancyGrid OccupancyGrid::with(const std::vector<MapPatch>& patches) const {
  OccupancyGrid grid = *this;
  for (const MapPatch& patch : patches) {
    checkFits(patch, lattice_);
    auto from = patch.cells.begin();
    for (int y = 0; y < patch.height; ++y, from += patch.width) {
      const std::size_t to = lattice_.index({patch.corner.x, patch.corner.y + y});
      std::copy_n(from, patch.width, grid.cells_.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
  return grid;
}

std::size_t OccupancyGrid::countFree() const {
  return static_cast<std::size_t>(std::count_if(
      cells_.begin(), cells_.end(), [](std::int8_t value) { return value >= 0 && value < 20; }));
}

void checkFits(const MapPatch& patch, const Lattice& lattice) {
  const auto [x, y] = patch.corner;
  const bool fits = patch.width > 0 && patch.height > 0 && x >= 0 && y >= 0 &&
                    patch.width <= lattice.width() - x && patch.height <= lattice.height() - y;
  const auto size =
      fits ? static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height) : 0;
  if (fits && patch.cells.size() == size) return;
  std::ostringstream text;
  text << "map update: got " << patch.cells.size() << " cells for " << patch.width << " x "
       << patch.height << " at (" << x << ", " << y << "), expected ";
  if (fits) {
    text << size;
  } else {
    text << "at least one, all within the map's " << lattice.width() << " x " << lattice.height();
  }
  throw std::invalid_argument(text.str());
}

}  // namespace adaptive_localization
