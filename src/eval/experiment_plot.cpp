// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/experiment_plot.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "canvas.hpp"

namespace adaptive_localization {
namespace {

constexpr int kWidth = 760, kHeight = 440;                       // px, of a panel
constexpr int kLeft = 64, kRight = 24, kTop = 44, kBottom = 52;  // px around the axes
constexpr int kColumns = 2;
const cv::Scalar kGrey(220, 220, 220), kWhite(255, 255, 255);

using Rows = std::vector<const ExperimentSummary*>;

std::vector<Rows> panelsOf(const std::vector<ExperimentSummary>& summaries) {
  std::vector<Rows> panels;
  for (const auto& row : summaries) {
    if (row.found.of == 0) continue;
    const bool goes_on = !panels.empty() && panels.back().front()->experiment == row.experiment &&
                         panels.back().front()->of_case == row.of_case;
    if (!goes_on) panels.emplace_back();
    panels.back().push_back(&row);
  }
  return panels;
}

/// The axes of a panel; time is spread as its square root, so that the first second shows.
struct Axes {
  double longest;  // s

  int x(double time) const {
    const double share = std::sqrt(std::min(time / longest, 1.0));
    return kLeft + static_cast<int>(std::lround((kWidth - kLeft - kRight) * share));
  }
  int y(double share) const {
    return kHeight - kBottom - static_cast<int>(std::lround((kHeight - kTop - kBottom) * share));
  }
};

void drawAxes(cv::Mat& panel, const Axes& axes, const std::string& title) {
  putText(panel, title, {kLeft, 26}, 0.6);
  for (const int percent : {0, 25, 50, 75, 100}) {
    const int y = axes.y(percent / 100.0);
    cv::line(panel, {kLeft, y}, {kWidth - kRight, y}, kGrey);
    putText(panel, cv::format("%3d %%", percent), {8, y + 5});
  }
  int last = -100;
  for (const double time : {0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0}) {
    const int x = axes.x(time);
    if (time > axes.longest || x - last < 36) continue;
    cv::line(panel, {x, axes.y(0.0)}, {x, axes.y(1.0)}, kGrey);
    putText(panel, cv::format("%g", time), {x - 8, kHeight - kBottom + 18});
    last = x;
  }
  putText(panel, "seconds until the robot is found", {kLeft, kHeight - 12});
}

/// The first curves are drawn thickest, so that they show beneath others that are the same.
int thicknessOf(std::size_t i, std::size_t count) {
  return 2 + 3 * static_cast<int>(std::min<std::size_t>(count - 1 - i, 3));
}

void drawCurve(cv::Mat& panel, const Axes& axes, const ExperimentSummary& row,
               const cv::Scalar& colour, int thickness) {
  std::vector<cv::Point> points{{axes.x(0.0), axes.y(0.0)}};
  for (std::size_t i = 0; i < row.found_s.size(); ++i) {
    const int x = axes.x(row.found_s[i]);
    points.emplace_back(x, points.back().y);
    points.emplace_back(x, axes.y(static_cast<double>(i + 1) / row.found.of));
  }
  points.emplace_back(axes.x(axes.longest), points.back().y);
  cv::polylines(panel, points, false, colour, thickness, cv::LINE_AA);
}

void drawLegend(cv::Mat& panel, const Rows& rows) {
  int y = kHeight - kBottom - 14 - 20 * static_cast<int>(rows.size() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i, y += 20) {
    const int x = kWidth - kRight - 210;
    cv::line(panel, {x, y - 5}, {x + 24, y - 5}, curveColour(i), 3, cv::LINE_AA);
    putText(panel, rows[i]->label, {x + 32, y});
  }
}

cv::Mat draw(const Rows& rows) {
  cv::Mat panel(kHeight, kWidth, CV_8UC3, kWhite);
  double longest = 1.0;
  for (const auto* row : rows) {
    if (!row->found_s.empty()) longest = std::max(longest, row->found_s.back());
  }
  const Axes axes{longest};
  drawAxes(panel, axes, rows.front()->experiment + ": " + rows.front()->of_case);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    drawCurve(panel, axes, *rows[i], curveColour(i), thicknessOf(i, rows.size()));
  }
  drawLegend(panel, rows);
  return panel;
}

}  // namespace

void savePlot(const std::vector<ExperimentSummary>& summaries, const std::string& file) {
  std::vector<cv::Mat> panels;
  for (const Rows& rows : panelsOf(summaries)) panels.push_back(draw(rows));
  if (panels.empty()) panels.emplace_back(kHeight, kWidth, CV_8UC3, kWhite);
  saveImage(tiled(panels, kColumns), "plot", file);
}

}  // namespace adaptive_localization
