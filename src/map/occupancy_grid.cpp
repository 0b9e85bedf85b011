// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/occupancy_grid.hpp"

#include <algorithm>
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

std::size_t OccupancyGrid::countFree() const {
  return static_cast<std::size_t>(std::count_if(
      cells_.begin(), cells_.end(), [](std::int8_t value) { return value >= 0 && value < 20; }));
}

}  // namespace adaptive_localization
