// SPDX-License-Identifier: BSD-3-Clause
#include "occupied_depth.hpp"

#include <opencv2/imgproc.hpp>

namespace adaptive_localization {

cv::Mat occupiedCells(const OccupancyGrid& map) {
  const CellBox& known = map.known();
  return occupiedCells(map, {known.x, known.y, known.width, known.height});
}

cv::Mat occupiedCells(const OccupancyGrid& map, const cv::Rect& box) {
  const CellBox& known = map.known();
  const cv::Rect stored(known.x, known.y, known.width, known.height);
  auto* cells = const_cast<std::int8_t*>(map.knownCells().data());  // OpenCV has no Mat of const
  const cv::Mat all(known.height, known.width, CV_8S, cells);
  cv::Mat occupied(box.size(), CV_8U, cv::Scalar(0));
  const cv::Rect both = box & stored;
  if (!both.empty()) {
    const cv::Mat is_occupied = all(both - stored.tl()) >= OccupancyGrid::kLeastOccupied;
    is_occupied.copyTo(occupied(both - box.tl()));
  }
  return occupied;
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
