// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

struct LegendRow {
  std::string text;
  cv::Scalar colour;
};

/// The colour (blue, green, red) of a cell, which may lie outside the map; none: leave it.
using CellColour = std::function<std::optional<cv::Vec3b>(const Cell&)>;

/// A picture of the part of a map that is in use, y up, with a margin above for the legend.
class Canvas {
 public:
  /// Shows all of the poses and what is so many metres around them.
  Canvas(const OccupancyGrid& map, const std::vector<Pose2>& poses, double surroundings = 3.0);

  void drawMap(const OccupancyGrid& map);
  void drawCells(const Lattice& lattice, const CellColour& colour_of);
  void drawPath(const std::vector<Pose2>& poses, const cv::Scalar& colour, int thickness);
  void drawDot(const Pose2& pose, const cv::Scalar& colour, int radius = 6);  // px
  void drawScaleBar();
  /// Three rows to a column, and the caption beside them.
  void drawLegend(const std::vector<LegendRow>& rows, const std::vector<std::string>& caption);

  const cv::Mat& image() const { return image_; }

 private:
  cv::Mat plane() const;  // the picture below the margin, in whose pixels points are
  cv::Point pixel(const Eigen::Vector2d& point_map, int fraction_bits = 0) const;

  double left_, top_;  // m, map frame, of the picture's upper left corner below the margin
  double pixels_per_metre_;
  int margin_;
  cv::Mat image_;
};

/// In the colours that curves of a chart have, one after the other.
cv::Scalar curveColour(std::size_t i);

void putText(cv::Mat& image, const std::string& text, const cv::Point& at, double size = 0.48);

/// Images of one size side by side, so many in a row, in one.
cv::Mat tiled(const std::vector<cv::Mat>& images, int columns);

/// Throws std::runtime_error saying what the image is and which file could not be written.
void saveImage(const cv::Mat& image, const std::string& what, const std::string& file);

}  // namespace adaptive_localization
