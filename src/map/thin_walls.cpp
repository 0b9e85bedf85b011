// SPDX-License-Identifier: BSD-3-Clause
#include "thin_walls.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "occupied_depth.hpp"

namespace adaptive_localization {
namespace {

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

OccupancyGrid withThinWalls(const OccupancyGrid& map, double wall_depth) {
  const Lattice& lattice = map.lattice();
  std::vector<std::int8_t> cells = map.cells();
  const cv::Mat depth = depthOf(occupiedCells(map));
  const double usual = 0.5 * wall_depth / lattice.resolution();  // cells
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = lattice.cell(i);
    if (!map.isOccupied(cell)) continue;
    const bool is_deep = static_cast<double>(depth.at<float>(cell.y, cell.x)) >= usual;
    if (!is_deep && !isRidge(depth, cell.x, cell.y)) cells[i] = OccupancyGrid::kFree;
  }
  return {lattice, std::move(cells)};
}

OccupancyGrid withHollowWalls(const OccupancyGrid& map) {
  const Lattice& lattice = map.lattice();
  std::vector<std::int8_t> cells = map.cells();
  const cv::Mat shut_in = shrunk(occupiedCells(map), cv::MORPH_CROSS, 1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = lattice.cell(i);
    if (shut_in.at<std::uint8_t>(cell.y, cell.x) != 0) cells[i] = OccupancyGrid::kFree;
  }
  return {lattice, std::move(cells)};
}

}  // namespace adaptive_localization
