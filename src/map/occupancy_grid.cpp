// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/occupancy_grid.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace adaptive_localization {
namespace {

bool isKnown(std::int8_t value) {
  return value >= 0;
}

CellBox boxAround(const Lattice& lattice) {
  return {0, 0, lattice.width(), lattice.height()};
}

/// The smallest box around the known cells of a box.
CellBox knownOf(const CellBox& box, const OccupancyGrid::Rows& rows) {
  int left = box.width, right = -1, bottom = box.height, top = -1;
  for (int row = 0; row < box.height; ++row) {
    const std::int8_t* cells = rows(row);
    const std::int8_t* const end = cells + box.width;
    const std::int8_t* const first = std::find_if(cells, end, isKnown);
    if (first == end) continue;
    const auto last =
        std::find_if(std::reverse_iterator(end), std::reverse_iterator(first), isKnown);
    left = std::min(left, static_cast<int>(first - cells));
    right = std::max(right, static_cast<int>(last.base() - cells) - 1);
    bottom = std::min(bottom, row);
    top = row;
  }
  if (top < 0) return {};
  return {box.x + left, box.y + bottom, right - left + 1, top - bottom + 1};
}

/// The smallest box around two, neither of which is empty.
CellBox around(const CellBox& a, const CellBox& b) {
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
          std::max(a.y + a.height, b.y + b.height) - y};
}

}  // namespace

OccupancyGrid::OccupancyGrid(const Lattice& lattice, const std::vector<std::int8_t>& cells)
    : OccupancyGrid(lattice) {
  if (cells.size() != lattice_.size()) {
    throw std::invalid_argument("map data: got " + std::to_string(cells.size()) +
                                " cells, expected " + std::to_string(lattice_.size()));
  }
  store(boxAround(lattice_), [&](int row) { return cells.data() + lattice_.index({0, row}); });
}

OccupancyGrid OccupancyGrid::fromRows(const Lattice& lattice, const Rows& rows) {
  OccupancyGrid grid(lattice);
  grid.store(boxAround(lattice), rows);
  return grid;
}

void OccupancyGrid::store(const CellBox& box, const Rows& rows) {
  known_ = knownOf(box, rows);
  known_cells_.reserve(known_.size());
  for (int row = 0; row < known_.height; ++row) {
    const std::int8_t* first = rows(known_.y - box.y + row) + (known_.x - box.x);
    known_cells_.insert(known_cells_.end(), first, first + known_.width);
  }
  has_speckle_ = looksSpeckled();
}

std::vector<std::int8_t> OccupancyGrid::cells() const {
  std::vector<std::int8_t> cells(lattice_.size(), kUnknown);
  for (std::size_t i = 0; i < known_cells_.size(); ++i) {
    cells[lattice_.index(known_.cell(i))] = known_cells_[i];
  }
  return cells;
}

OccupancyGrid OccupancyGrid::with(const std::vector<MapPatch>& patches) const {
  CellBox box = known_;
  for (const MapPatch& patch : patches) {
    checkFits(patch, lattice_);
    const CellBox changed{patch.corner.x, patch.corner.y, patch.width, patch.height};
    box = box.size() == 0 ? changed : around(box, changed);
  }
  std::vector<std::int8_t> cells(box.size());
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = at(box.cell(i));
  for (const MapPatch& patch : patches) {
    auto from = patch.cells.begin();
    for (int y = 0; y < patch.height; ++y, from += patch.width) {
      const std::size_t to = box.index({patch.corner.x, patch.corner.y + y});
      std::copy_n(from, patch.width, cells.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
  OccupancyGrid grid(lattice_);
  grid.store(box, [&](int row) { return cells.data() + box.index({box.x, box.y + row}); });
  return grid;
}

int OccupancyGrid::occupiedAround(const Cell& cell) const {
  constexpr int kReach = kSpeckleReach;
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
  for (std::size_t i = 0; i < known_cells_.size(); ++i) {
    if (known_cells_[i] < kLeastOccupied) continue;
    const int together = occupiedAround(known_.cell(i));
    ++all;
    isolated += together == 1 ? 1 : 0;
    in_pairs += together == 2 ? 1 : 0;
  }
  return isolated > kFew &&
         static_cast<double>(isolated) > kLeastShare * static_cast<double>(all) &&
         static_cast<double>(in_pairs) < kMostPairs * static_cast<double>(isolated);
}

std::size_t OccupancyGrid::countFree() const {
  return static_cast<std::size_t>(
      std::count_if(known_cells_.begin(), known_cells_.end(),
                    [](std::int8_t value) { return value >= 0 && value < 20; }));
}

std::size_t OccupancyGrid::countKnown() const {
  return static_cast<std::size_t>(std::count_if(known_cells_.begin(), known_cells_.end(), isKnown));
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
