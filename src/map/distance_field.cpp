// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/distance_field.hpp"

#include <opencv2/imgproc.hpp>

namespace adaptive_localization {
namespace {

bool isSurface(const OccupancyGrid& grid, const Cell& c) {
  return grid.isOccupied(c) &&
         !(grid.isOccupied({c.x - 1, c.y}) && grid.isOccupied({c.x + 1, c.y}) &&
           grid.isOccupied({c.x, c.y - 1}) && grid.isOccupied({c.x, c.y + 1}));
}

}  // namespace

DistanceField::DistanceField(const OccupancyGrid& grid)
    : lattice_(grid.lattice()), step_(lattice_.resolution() / kStepsPerCell) {
  steps_.assign(lattice_.size(), kFar);
  cv::Mat surface(lattice_.height(), lattice_.width(), CV_8U);
  bool any = false;
  for (std::size_t i = 0; i < lattice_.size(); ++i) {
    const bool hit = isSurface(grid, lattice_.cell(i));
    surface.data[i] = hit ? 0 : 255;
    any = any || hit;
  }
  if (!any) return;
  cv::Mat cells;
  cv::distanceTransform(surface, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  cv::Mat steps(lattice_.height(), lattice_.width(), CV_16U, steps_.data());
  cells.convertTo(steps, CV_16U, kStepsPerCell);
}

}  // namespace adaptive_localization
