// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// 255 in occupied cells, 0 elsewhere; a row per row of the box around the map's known cells.
cv::Mat occupiedCells(const OccupancyGrid& map);

/// The same of a box of the map.
cv::Mat occupiedCells(const OccupancyGrid& map, const cv::Rect& box);

/// Those that have occupied cells alone around them, in a cross or square (cv::MorphShapes) so many
/// cells to each side; what is outside the map is not occupied.
cv::Mat shrunk(const cv::Mat& occupied, int shape, int reach);

/// How far occupied cells are from the nearest one that is not, in cells; what is outside the map
/// is not occupied. 0 in all others.
cv::Mat depthOf(const cv::Mat& occupied);

}  // namespace adaptive_localization
