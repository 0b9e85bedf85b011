// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace adaptive_localization {
namespace {

constexpr int kLongSide = 1400;     // px
constexpr int kMargin = 84;         // px, for legend and caption
constexpr double kNarrowest = 8.0;  // m shown at least
constexpr double kSlimmest = 0.6;   // width by height at least, so that the caption fits
constexpr double kFarthest = 1e6;   // m; a pose further off is not drawn
constexpr int kFractionBits = 4;    // OpenCV's sub-pixel coordinates
constexpr double kTextSize = 0.55;
const cv::Scalar kBlack(0, 0, 0);

struct Box {
  double left{std::numeric_limits<double>::infinity()}, right{-left};
  double bottom{std::numeric_limits<double>::infinity()}, top{-bottom};

  void include(double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    bottom = std::min(bottom, y);
    top = std::max(top, y);
  }
  void grow(double by) { left -= by, right += by, bottom -= by, top += by; }
};

bool canBeDrawn(const Pose2& pose) {
  return isFinite(pose) && std::abs(pose.x) < kFarthest && std::abs(pose.y) < kFarthest;
}

}  // namespace

Canvas::Canvas(const OccupancyGrid& map, const std::vector<Pose2>& poses, double surroundings)
    : margin_(kMargin) {
  Box box;
  for (const auto& pose : poses) {
    if (canBeDrawn(pose)) box.include(pose.x, pose.y);
  }
  if (!std::isfinite(box.left)) {
    const auto centre =
        map.lattice().centre({map.lattice().width() / 2, map.lattice().height() / 2});
    box.include(centre.x(), centre.y());
  }
  const double widest = std::max(box.right - box.left, box.top - box.bottom);
  box.grow(std::max(surroundings, 0.5 * (kNarrowest - widest)));
  const double lacking = kSlimmest * (box.top - box.bottom) - (box.right - box.left);
  box.left -= std::max(0.0, 0.5 * lacking);
  box.right += std::max(0.0, 0.5 * lacking);
  left_ = box.left;
  top_ = box.top;
  pixels_per_metre_ = kLongSide / std::max(box.right - box.left, box.top - box.bottom);
  const int width = static_cast<int>(std::ceil((box.right - box.left) * pixels_per_metre_));
  const int height = static_cast<int>(std::ceil((box.top - box.bottom) * pixels_per_metre_));
  image_ = cv::Mat(height + margin_, width, CV_8UC3, cv::Scalar(255, 255, 255));
}

cv::Mat Canvas::plane() const {
  return image_.rowRange(margin_, image_.rows);
}

cv::Point Canvas::pixel(const Eigen::Vector2d& point_map, int fraction_bits) const {
  const double scale = 1 << fraction_bits;
  return {static_cast<int>(std::lround((point_map.x() - left_) * pixels_per_metre_ * scale)),
          static_cast<int>(std::lround((top_ - point_map.y()) * pixels_per_metre_ * scale))};
}

void Canvas::drawMap(const OccupancyGrid& map) {
  drawCells(map.lattice(), [&map](const Cell& cell) -> std::optional<cv::Vec3b> {
    const unsigned char grey = map.isOccupied(cell) ? 0 : map.isFree(cell) ? 255 : 215;
    return cv::Vec3b(grey, grey, grey);
  });
}

void Canvas::drawCells(const Lattice& lattice, const CellColour& colour_of) {
  for (int row = margin_; row < image_.rows; ++row) {
    for (int column = 0; column < image_.cols; ++column) {
      const Eigen::Vector2d point(left_ + (column + 0.5) / pixels_per_metre_,
                                  top_ - (row - margin_ + 0.5) / pixels_per_metre_);
      const auto colour = colour_of(lattice.cellAt(point));
      if (colour) image_.at<cv::Vec3b>(row, column) = *colour;
    }
  }
}

void Canvas::drawPath(const std::vector<Pose2>& poses, const cv::Scalar& colour, int thickness) {
  std::vector<cv::Point> points;
  for (const auto& pose : poses) {
    if (canBeDrawn(pose)) points.push_back(pixel({pose.x, pose.y}, kFractionBits));
  }
  cv::Mat below_the_margin = plane();
  cv::polylines(below_the_margin, points, false, colour, thickness, cv::LINE_AA, kFractionBits);
}

void Canvas::drawDot(const Pose2& pose, const cv::Scalar& colour, int radius) {
  if (!canBeDrawn(pose)) return;
  cv::Mat below_the_margin = plane();
  cv::circle(below_the_margin, pixel({pose.x, pose.y}), radius, colour, -1, cv::LINE_AA);
}

void Canvas::drawScaleBar() {
  double length = 1.0;  // m; the longest of 1, 2, 5, 10, ... below a fifth of the width
  const double limit = 0.2 * image_.cols / pixels_per_metre_;
  for (int i = 0; length * (i % 3 == 1 ? 2.5 : 2.0) <= limit; ++i) length *= i % 3 == 1 ? 2.5 : 2.0;
  const int pixels = static_cast<int>(std::lround(length * pixels_per_metre_));
  const cv::Point right(image_.cols - 20, margin_ - 18);
  const cv::Point left(right.x - pixels, right.y);
  cv::line(image_, left, right, kBlack, 2);
  for (const auto& end : {left, right}) {
    cv::line(image_, end - cv::Point(0, 6), end + cv::Point(0, 6), kBlack, 2);
  }
  putText(image_, cv::format("%.0f m", length), {left.x + pixels / 2 - 18, right.y - 12},
          kTextSize);
}

void Canvas::drawLegend(const std::vector<LegendRow>& rows,
                        const std::vector<std::string>& caption) {
  constexpr int kRows = 3;
  constexpr int kTop = 22, kRowHeight = 24, kFirstColumn = 166, kColumn = 280;  // px
  int column_left = 14;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && i % kRows == 0) column_left += kColumn;
    const int y = kTop + kRowHeight * static_cast<int>(i % kRows);
    cv::line(image_, {column_left, y - 5}, {column_left + 32, y - 5}, rows[i].colour, 4,
             cv::LINE_AA);
    putText(image_, rows[i].text, {column_left + 42, y}, kTextSize);
  }
  int y = kTop;
  for (const auto& line : caption) {
    putText(image_, line, {column_left + (rows.size() > kRows ? kColumn : kFirstColumn), y},
            kTextSize);
    y += kRowHeight;
  }
}

cv::Scalar curveColour(std::size_t i) {
  const cv::Scalar colours[] = {{180, 119, 31},  {14, 127, 255}, {44, 160, 44},   {40, 39, 214},
                                {189, 103, 148}, {75, 86, 140},  {194, 119, 227}, {127, 127, 127}};
  return colours[i % std::size(colours)];
}

void putText(cv::Mat& image, const std::string& text, const cv::Point& at, double size) {
  cv::putText(image, text, at, cv::FONT_HERSHEY_SIMPLEX, size, kBlack, 1, cv::LINE_AA);
}

cv::Mat tiled(const std::vector<cv::Mat>& images, int columns) {
  const int count = static_cast<int>(images.size());
  const cv::Size size = images.at(0).size();
  const int rows = (count + columns - 1) / columns;
  cv::Mat whole(size.height * rows, size.width * std::min(count, columns), CV_8UC3,
                cv::Scalar(255, 255, 255));
  for (int i = 0; i < count; ++i) {
    const cv::Point corner(size.width * (i % columns), size.height * (i / columns));
    images[static_cast<std::size_t>(i)].copyTo(whole(cv::Rect(corner, size)));
  }
  return whole;
}

void saveImage(const cv::Mat& image, const std::string& what, const std::string& file) {
  bool is_written = false;
  try {
    is_written = cv::imwrite(file, image);
  } catch (const cv::Exception&) {  // an ending that OpenCV has no writer for
  }
  if (is_written) return;
  throw std::runtime_error(what + " '" + file + "': cannot be written, expected a name like x.png");
}

}  // namespace adaptive_localization
