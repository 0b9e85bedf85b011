// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/map_quality.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "occupied_depth.hpp"

namespace adaptive_localization {
namespace {

constexpr double kGoodHits = 0.04, kPoorHits = 0.2;  // m, deviations on good and poor maps

/// In cells, of walls two cells deep and deeper. A face is a cell that is not shut in by occupied
/// ones on its four sides. Counted in strips of rows, so that a large map is not copied.
double cellsDeep(const OccupancyGrid& map) {
  constexpr int kStrip = 256;  // rows
  const CellBox& known = map.known();
  const cv::Rect all(known.x, known.y, known.width, known.height);
  double count = 0.0, shut_in = 0.0;
  for (int row = all.y; row < all.br().y; row += kStrip) {
    const cv::Rect strip = cv::Rect(all.x, row, all.width, kStrip) & all;
    const cv::Rect with_neighbours = cv::Rect(all.x, row - 1, all.width, kStrip + 2) & all;
    const cv::Mat occupied = occupiedCells(map, with_neighbours);
    const cv::Rect here = strip - with_neighbours.tl();
    const int occupied_here = cv::countNonZero(occupied(here));
    if (occupied_here == 0) continue;
    count += occupied_here;
    shut_in += cv::countNonZero(shrunk(occupied, cv::MORPH_CROSS, 1)(here));
  }
  return count > 0.0 ? 2.0 * count / (count - shut_in) : 0.0;
}

/// By how much the depth, in cells, varies where it is greatest of all around: the standard
/// deviation from the mean of a square of so many cells, as one building has walls of many kinds.
double deviationAlongMiddles(const OccupancyGrid& map, double side) {
  struct Square {
    double count{0.0}, sum{0.0}, squares{0.0};
  };
  const cv::Mat occupied = occupiedCells(map);
  const cv::Mat depth = depthOf(occupied);
  cv::Mat greatest;
  cv::dilate(depth, greatest, cv::Mat());
  std::vector<cv::Point> middles;
  cv::findNonZero((depth >= greatest) & occupied, middles);
  std::map<std::pair<int, int>, Square> squares;
  for (const cv::Point& cell : middles) {
    const double d = static_cast<double>(depth.at<float>(cell));
    Square& square = squares[{static_cast<int>((map.known().x + cell.x) / side),
                              static_cast<int>((map.known().y + cell.y) / side)}];
    square.count += 1.0;
    square.sum += d;
    square.squares += d * d;
  }
  double sum = 0.0;
  for (const auto& [place, square] : squares) {
    sum += square.squares - square.sum * square.sum / square.count;
  }
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(middles.size()));
}

}  // namespace

MapQuality::MapQuality(const OccupancyGrid& map) : resolution_(map.lattice().resolution()) {
  constexpr double kPiece = 2.0;  // m, of a wall
  constexpr double kThick = 3.5;  // cells; maps of walls seen from their sides have 2.0 to 2.8
  const double cells = cellsDeep(map);
  wall_depth_ = cells * resolution_;
  has_thick_walls_ = cells > kThick;
  roughness_ =
      has_thick_walls_ ? deviationAlongMiddles(map, kPiece / resolution_) * resolution_ : 0.0;
}

double MapQuality::hitDeviation() const {
  return std::clamp(3.0 * roughness_, kGoodHits, kPoorHits);
}

double MapQuality::middleDeviation() const {
  return std::clamp(1.5 * roughness_, kGoodHits, kPoorHits);
}

double MapQuality::rangeError() const {
  constexpr double kGoodMap = 0.05;  // m
  constexpr double kPoorMap = 0.2;   // m, at the most: maps painted from plans have solid walls
  return std::clamp(kGoodMap + 0.5 * wall_depth_ - resolution_, kGoodMap, kPoorMap);
}

}  // namespace adaptive_localization
