// SPDX-License-Identifier: BSD-3-Clause
#include "thin_walls.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

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

/// The map with those cells free of which `isFreed(x, y)` says so, columns and rows of the box
/// around its known cells.
template <class IsFreed>
OccupancyGrid withFree(const OccupancyGrid& map, const IsFreed& isFreed) {
  const CellBox& known = map.known();
  MapPatch patch{{known.x, known.y}, known.width, known.height, map.knownCells()};
  for (int y = 0; y < known.height; ++y) {
    for (int x = 0; x < known.width; ++x) {
      if (!isFreed(x, y)) continue;
      patch.cells[known.index({known.x + x, known.y + y})] = OccupancyGrid::kFree;
    }
  }
  return map.with({patch});
}

}  // namespace

OccupancyGrid withThinWalls(const OccupancyGrid& map, double wall_depth) {
  const cv::Mat depth = depthOf(occupiedCells(map));
  const double usual = 0.5 * wall_depth / map.lattice().resolution();  // cells
  return withFree(map, [&](int x, int y) {
    if (depth.at<float>(y, x) == 0.0F) return false;
    return static_cast<double>(depth.at<float>(y, x)) < usual && !isRidge(depth, x, y);
  });
}

OccupancyGrid withHollowWalls(const OccupancyGrid& map) {
  const cv::Mat shut_in = shrunk(occupiedCells(map), cv::MORPH_CROSS, 1);
  return withFree(map, [&](int x, int y) { return shut_in.at<std::uint8_t>(y, x) != 0; });
}

}  // namespace adaptive_localization
