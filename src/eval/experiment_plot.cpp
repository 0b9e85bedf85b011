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

/// Numbers of particles go from 10 to 100 000, by tens.
double shareOfParticles(double count) {
  return std::clamp((std::log10(std::max(count, 1.0)) - 1.0) / 4.0, 0.0, 1.0);
}

void drawLevel(cv::Mat& panel, const Axes& axes, double share, const std::string& name) {
  const int y = axes.y(share);
  cv::line(panel, {kLeft, y}, {kWidth - kRight, y}, kGrey);
  putText(panel, name, {8, y + 5});
}

void drawAxes(cv::Mat& panel, const Axes& axes, const std::string& title, const std::string& time) {
  putText(panel, title, {kLeft, 26}, 0.6);
  int last = -100;
  for (const double at : {0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0}) {
    const int x = axes.x(at);
    if (at > axes.longest || x - last < 36) continue;
    cv::line(panel, {x, axes.y(0.0)}, {x, axes.y(1.0)}, kGrey);
    putText(panel, cv::format("%g", at), {x - 8, kHeight - kBottom + 18});
    last = x;
  }
  putText(panel, time, {kLeft, kHeight - 12});
}

/// The first curves are drawn thickest, so that they show beneath others that are the same.
int thicknessOf(std::size_t i, std::size_t count) {
  return 2 + 3 * static_cast<int>(std::min<std::size_t>(count - 1 - i, 3));
}

std::vector<cv::Point> foundCurve(const Axes& axes, const ExperimentSummary& row) {
  std::vector<cv::Point> points{{axes.x(0.0), axes.y(0.0)}};
  for (std::size_t i = 0; i < row.found_s.size(); ++i) {
    const int x = axes.x(row.found_s[i]);
    points.emplace_back(x, points.back().y);
    points.emplace_back(x, axes.y(static_cast<double>(i + 1) / row.found.of));
  }
  points.emplace_back(axes.x(axes.longest), points.back().y);
  return points;
}

std::vector<cv::Point> particlesCurve(const Axes& axes, const ExperimentSummary& row) {
  std::vector<cv::Point> points;
  for (std::size_t i = 0; i < row.particles_by_s.size(); ++i) {
    points.emplace_back(axes.x(static_cast<double>(i)),
                        axes.y(shareOfParticles(row.particles_by_s[i])));
  }
  return points;
}

void drawLegend(cv::Mat& panel, const Rows& rows) {
  int y = kHeight - kBottom - 14 - 20 * static_cast<int>(rows.size() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i, y += 20) {
    const int x = kWidth - kRight - 210;
    cv::line(panel, {x, y - 5}, {x + 24, y - 5}, curveColour(i), 3, cv::LINE_AA);
    putText(panel, rows[i]->label, {x + 32, y});
  }
}

using Curve = std::vector<cv::Point> (*)(const Axes&, const ExperimentSummary&);

void drawCurves(cv::Mat& panel, const Axes& axes, const Rows& rows, Curve curve) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    cv::polylines(panel, curve(axes, *rows[i]), false, curveColour(i), thicknessOf(i, rows.size()),
                  cv::LINE_AA);
  }
}

std::string titleOf(const Rows& rows) {
  return rows.front()->experiment + ": " + rows.front()->of_case;
}

cv::Mat drawFound(const Rows& rows) {
  cv::Mat panel(kHeight, kWidth, CV_8UC3, kWhite);
  double longest = 1.0;
  for (const auto* row : rows) {
    if (!row->found_s.empty()) longest = std::max(longest, row->found_s.back());
  }
  const Axes axes{longest};
  drawAxes(panel, axes, titleOf(rows), "seconds until the robot is found");
  for (const int percent : {0, 25, 50, 75, 100})
    drawLevel(panel, axes, percent / 100.0, cv::format("%3d %%", percent));
  drawCurves(panel, axes, rows, foundCurve);
  drawLegend(panel, rows);
  return panel;
}

cv::Mat drawParticles(const Rows& rows) {
  cv::Mat panel(kHeight, kWidth, CV_8UC3, kWhite);
  double longest = 1.0;
  for (const auto* row : rows) {
    longest = std::max(longest, static_cast<double>(row->particles_by_s.size()) - 1.0);
  }
  const Axes axes{longest};
  drawAxes(panel, axes, titleOf(rows) + ", particles", "seconds of the run");
  for (const int count : {10, 100, 1000, 10000, 100000})
    drawLevel(panel, axes, shareOfParticles(count), std::to_string(count));
  drawCurves(panel, axes, rows, particlesCurve);
  drawLegend(panel, rows);
  return panel;
}

}  // namespace

void savePlot(const std::vector<ExperimentSummary>& summaries, const std::string& file) {
  std::vector<cv::Mat> panels;
  for (const Rows& rows : panelsOf(summaries)) {
    panels.push_back(drawFound(rows));
    panels.push_back(drawParticles(rows));
  }
  if (panels.empty()) panels.emplace_back(kHeight, kWidth, CV_8UC3, kWhite);
  saveImage(tiled(panels, kColumns), "plot", file);
}

}  // namespace adaptive_localization
