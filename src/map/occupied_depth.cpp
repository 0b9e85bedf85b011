// SPDX-License-Identifier: BSD-3-Clause
#include "occupied_depth.hpp"

#include <opencv2/imgproc.hpp>

namespace adaptive_localization {

cv::Mat occupiedCells(const OccupancyGrid& map) {
  const Lattice& lattice = map.lattice();
  cv::Mat occupied(lattice.height(), lattice.width(), CV_8U);
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    occupied.data[i] = map.cells()[i] == OccupancyGrid::kOccupied ? 255 : 0;
  }
  return occupied;
}

cv::Mat depthOf(const cv::Mat& occupied) {
  cv::Mat framed, depth;
  cv::copyMakeBorder(occupied, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(framed, depth, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return depth(cv::Rect(1, 1, occupied.cols, occupied.rows));
}

}  // namespace adaptive_localization
