// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/wall_depth.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "occupied_depth.hpp"

namespace adaptive_localization {
namespace {

/// In cells, of walls two cells deep and deeper. A face is a cell that is not shut in by occupied
/// ones on its four sides.
double cellsDeep(const OccupancyGrid& map) {
  const cv::Mat walls = occupiedCells(map);
  const int occupied = cv::countNonZero(walls);
  if (occupied == 0) return 0.0;
  const int shut_in = cv::countNonZero(shrunk(walls, cv::MORPH_CROSS, 1));
  return 2.0 * occupied / (occupied - shut_in);
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
