// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/occupancy_grid.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace adaptive_localization {

OccupancyGrid::OccupancyGrid(const Lattice& lattice, std::vector<std::int8_t> cells)
    : lattice_(lattice), cells_(std::move(cells)), has_speckle_(false) {
  if (cells_.size() != lattice_.size()) {
    throw std::invalid_argument("map data: got " + std::to_string(cells_.size()) +
                                " cells, expected " + std::to_string(lattice_.size()));
  }
  has_speckle_ = looksSpeckled();
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
  grid.has_speckle_ = grid.looksSpeckled();
  return grid;
}

int OccupancyGrid::occupiedAround(const Cell& cell) const {
  constexpr int kReach = kSpeckleReach, kMany = 3;
  int occupied = 0;
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      occupied += isOccupied({cell.x + dx, cell.y + dy}) ? 1 : 0;
      if (occupied == kMany) return kMany;
    }
  }
  return occupied;
}

/// Of noise that occupies a share p of the cells, 24 p times as many come in pairs as are isolated:
/// 0.1 to 0.4. On maps that robots made it is 0.9 to 2. Coarse cells can be columns.
bool OccupancyGrid::looksSpeckled() const {
  constexpr std::size_t kFew = 10;
  constexpr double kLeastShare = 0.03, kMostPairs = 0.5;
  constexpr double kColumn = 0.15;  // m
  if (lattice_.resolution() > kColumn) return false;
  std::size_t all = 0, isolated = 0, in_pairs = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i] < kLeastOccupied) continue;
    const int around = occupiedAround(lattice_.cell(i));
    ++all;
    isolated += around == 1 ? 1 : 0;
    in_pairs += around == 2 ? 1 : 0;
  }
  return isolated > kFew &&
         static_cast<double>(isolated) > kLeastShare * static_cast<double>(all) &&
         static_cast<double>(in_pairs) < kMostPairs * static_cast<double>(isolated);
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
