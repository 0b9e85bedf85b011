// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace adaptive_localization {
namespace {

bool isSurface(const OccupancyGrid& grid, const Cell& c) {
  return grid.isOccupied(c) &&
         !(grid.isOccupied({c.x - 1, c.y}) && grid.isOccupied({c.x + 1, c.y}) &&
           grid.isOccupied({c.x, c.y - 1}) && grid.isOccupied({c.x, c.y + 1}));
}

}  // namespace

DistanceField::DistanceField(const OccupancyGrid& grid, const StopToken& stop)
    : lattice_(grid.lattice()), step_(lattice_.resolution() / kStepsPerCell) {
  steps_.assign(lattice_.size(), kFar);
  cv::Mat surface(lattice_.height(), lattice_.width(), CV_8U);
  bool any = false;
  for (std::size_t i = 0; i < lattice_.size(); ++i) {
    const bool hit = isSurface(grid, lattice_.cell(i));
    surface.data[i] = hit ? 0 : 255;
    any = any || hit;
  }
  stop.check();
  if (!any) return;
  cv::Mat cells;
  cv::distanceTransform(surface, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
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
