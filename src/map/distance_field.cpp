// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "occupied_depth.hpp"

namespace adaptive_localization {
namespace {

/// Those of the occupied cells that are so many cells deep or less. A deeper one is the middle of a
/// square of occupied cells that fits into the circle; most maps have none.
cv::Mat notDeeper(const cv::Mat& occupied, double most) {
  const auto reach = static_cast<int>(most / std::sqrt(2.0));
  if (cv::countNonZero(shrunk(occupied, cv::MORPH_RECT, reach)) == 0) return occupied;
  return occupied & (depthOf(occupied) <= most);
}

/// 0 in the cells of walls, 255 elsewhere; empty if there are none.
cv::Mat wallsOf(const OccupancyGrid& grid, const StopToken& stop) {
  const cv::Mat occupied = occupiedCells(grid);
  if (cv::countNonZero(occupied) == 0) return {};
  stop.check();
  const cv::Mat walls = notDeeper(occupied, 1.0 + kWallDepth / grid.lattice().resolution());
  stop.check();
  return walls == 0;
}

}  // namespace

DistanceField::DistanceField(const OccupancyGrid& grid, const StopToken& stop)
    : lattice_(grid.lattice()), step_(lattice_.resolution() / kStepsPerCell), quality_(grid) {
  steps_.assign(lattice_.size(), kFar);
  const cv::Mat walls = wallsOf(grid, stop);
  if (walls.empty()) return;
  cv::Mat cells;
  cv::distanceTransform(walls, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  stop.check();
  cv::Mat steps(lattice_.height(), lattice_.width(), CV_16U, steps_.data());
  cells.convertTo(steps, CV_16U, kStepsPerCell);
}

double DistanceField::between(const Eigen::Vector2d& point_map) const {
  const Pose2 local = lattice_.toLattice({point_map.x(), point_map.y(), 0.0});
  const double x = local.x / lattice_.resolution() - 0.5;
  const double y = local.y / lattice_.resolution() - 0.5;
  if (!(x > -0.5 && y > -0.5 && x < lattice_.width() - 0.5 && y < lattice_.height() - 0.5)) {
    return step_ * kFar;
  }
  const Cell low{static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
  const auto value = [&](int dx, int dy) {
    return at(Cell{std::min(std::max(low.x + dx, 0), lattice_.width() - 1),
                   std::min(std::max(low.y + dy, 0), lattice_.height() - 1)});
  };
  const double below = value(0, 0) + (x - low.x) * (value(1, 0) - value(0, 0));
  const double above = value(0, 1) + (x - low.x) * (value(1, 1) - value(0, 1));
  return below + (y - low.y) * (above - below);
}

}  // namespace adaptive_localization
