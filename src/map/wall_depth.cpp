// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/wall_depth.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "occupied_depth.hpp"

namespace adaptive_localization {
namespace {

/// Occupied, and not shut in by occupied cells on its four sides.
bool isFace(const OccupancyGrid& map, const Cell& c) {
  return !(map.isOccupied({c.x - 1, c.y}) && map.isOccupied({c.x + 1, c.y}) &&
           map.isOccupied({c.x, c.y - 1}) && map.isOccupied({c.x, c.y + 1}));
}

/// In cells, of walls two cells deep and deeper.
double cellsDeep(const OccupancyGrid& map) {
  std::size_t occupied = 0, faces = 0;
  for (std::size_t i = 0; i < map.cells().size(); ++i) {
    if (map.cells()[i] != OccupancyGrid::kOccupied) continue;
    ++occupied;
    faces += isFace(map, map.lattice().cell(i)) ? 1U : 0U;
  }
  return faces == 0 ? 0.0 : 2.0 * static_cast<double>(occupied) / static_cast<double>(faces);
}

/// As deep as both neighbours in some direction, and deeper than one of them.
bool isRidge(const cv::Mat& depth, int x, int y) {
  const float here = depth.at<float>(y, x);
  const auto at = [&](int dx, int dy) {
    const bool is_inside = x + dx >= 0 && y + dy >= 0 && x + dx < depth.cols && y + dy < depth.rows;
    return is_inside ? depth.at<float>(y + dy, x + dx) : 0.0F;
  };
  float deepest = here;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) deepest = std::max(deepest, at(dx, dy));
  }
  if (here < 0.8F * deepest) return false;
  for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
    const float a = at(dx, dy), b = at(-dx, -dy);
    if (here >= a && here >= b && here > std::min(a, b)) return true;
  }
  return false;
}

}  // namespace

double wallDepth(const OccupancyGrid& map) {
  return cellsDeep(map) * map.lattice().resolution();
}

bool hasThickWalls(const OccupancyGrid& map) {
  constexpr double kThick = 3.5;  // cells; maps of walls seen from their sides have 2.0 to 2.4
  return cellsDeep(map) > kThick;
}

OccupancyGrid withThinWalls(const OccupancyGrid& map) {
  const Lattice& lattice = map.lattice();
  std::vector<std::int8_t> cells = map.cells();
  const cv::Mat depth = depthOf(occupiedCells(map));
  const double usual = 0.5 * cellsDeep(map);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] != OccupancyGrid::kOccupied) continue;
    const Cell cell = lattice.cell(i);
    const bool is_deep = static_cast<double>(depth.at<float>(cell.y, cell.x)) >= usual;
    if (!is_deep && !isRidge(depth, cell.x, cell.y)) cells[i] = OccupancyGrid::kFree;
  }
  return {lattice, std::move(cells)};
}

}  // namespace adaptive_localization
