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
  const Eigen::Vector2d cells = lattice_.toLattice(point_map) / lattice_.resolution();
  return step_ * stepsBetween(cells.x() - 0.5, cells.y() - 0.5);
}

double DistanceField::sumBetween(const Pose2& T_map_base, const Eigen::ArrayXf& x,
                                 const Eigen::ArrayXf& y, Eigen::Index stride, double most) const {
  const Pose2 base = lattice_.toLattice(T_map_base);
  const double per_metre = 1.0 / lattice_.resolution();
  const double c = per_metre * std::cos(base.theta), s = per_metre * std::sin(base.theta);
  const double at_x = per_metre * base.x - 0.5, at_y = per_metre * base.y - 0.5;
  const double most_steps = most / step_;
  double sum = 0.0;
  for (Eigen::Index i = 0; i < x.size(); i += stride) {
    const double px = x[i], py = y[i];
    const double steps = stepsBetween(at_x + c * px - s * py, at_y + s * px + c * py);
    sum += std::min(steps, most_steps);
  }
  return step_ * sum;
}

/// Between the four cells around a point, given in cells from the centre of the first.
double DistanceField::stepsBetween(double x, double y) const {
  const int last_x = lattice_.width() - 1, last_y = lattice_.height() - 1;
  if (!(x > -0.5 && y > -0.5 && x < last_x + 0.5 && y < last_y + 0.5)) return kFar;
  const int left = static_cast<int>(x + 1.0) - 1, low = static_cast<int>(y + 1.0) - 1;  // floors
  const std::uint16_t* lower = &steps_[lattice_.index({0, std::max(low, 0)})];
  const std::uint16_t* upper = &steps_[lattice_.index({0, std::min(low + 1, last_y)})];
  const int first = std::max(left, 0), second = std::min(left + 1, last_x);
  const double below = lower[first] + (x - left) * (lower[second] - lower[first]);
  const double above = upper[first] + (x - left) * (upper[second] - upper[first]);
  return below + (y - low) * (above - below);
}

}  // namespace adaptive_localization
