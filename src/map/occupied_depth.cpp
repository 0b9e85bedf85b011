// SPDX-License-Identifier: BSD-3-Clause
#include "occupied_depth.hpp"

#include <opencv2/imgproc.hpp>

namespace adaptive_localization {

cv::Mat occupiedCells(const OccupancyGrid& map) {
  return occupiedCells(map, {0, 0, map.lattice().width(), map.lattice().height()});
}

cv::Mat occupiedCells(const OccupancyGrid& map, const cv::Rect& box) {
  const Lattice& lattice = map.lattice();
  auto* cells = const_cast<std::int8_t*>(map.cells().data());  // OpenCV has no Mat of const
  const cv::Mat all(lattice.height(), lattice.width(), CV_8S, cells);
  return all(box) >= OccupancyGrid::kLeastOccupied;
}

cv::Mat shrunk(const cv::Mat& occupied, int shape, int reach) {
  cv::Mat left;
  const cv::Mat element = cv::getStructuringElement(shape, {2 * reach + 1, 2 * reach + 1});
  cv::erode(occupied, left, element, {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  return left;
}

cv::Mat depthOf(const cv::Mat& occupied) {
  cv::Mat framed, depth;
  cv::copyMakeBorder(occupied, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(framed, depth, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return depth(cv::Rect(1, 1, occupied.cols, occupied.rows));
}

}  // namespace adaptive_localization
