// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "adaptive_localization/eval/swarm_race.hpp"
#include "canvas.hpp"

namespace adaptive_localization {
namespace {

constexpr int kWidth = 740, kHeight = 440;                        // px, of a panel
constexpr int kLeft = 64, kRight = 250, kTop = 44, kBottom = 52;  // px around the axes
constexpr double kFewest = 20.0, kMost = 1200.0, kIterations = 500.0;
const cv::Scalar kGrey(220, 220, 220), kWhite(255, 255, 255);
constexpr int kPanelsInRow = 3;

/// Both axes are logarithmic.
cv::Point place(double searchers, double iterations) {
  const double right = std::log(searchers / kFewest) / std::log(kMost / kFewest);
  const double up = std::log(std::max(iterations, 1.0)) / std::log(kIterations);
  return {kLeft + static_cast<int>(std::lround((kWidth - kLeft - kRight) * right)),
          kHeight - kBottom - static_cast<int>(std::lround((kHeight - kTop - kBottom) * up))};
}

void drawAxes(cv::Mat& panel, const std::string& title) {
  putText(panel, title, {kLeft, 26}, 0.6);
  for (const double iterations : {1.0, 5.0, 20.0, 100.0, 500.0}) {
    cv::line(panel, place(kFewest, iterations), place(kMost, iterations), kGrey);
    putText(panel, cv::format("%4.0f", iterations), {12, place(kFewest, iterations).y + 5});
  }
  for (const double searchers : {20.0, 50.0, 100.0, 300.0, 600.0, 1200.0}) {
    cv::line(panel, place(searchers, 1.0), place(searchers, kIterations), kGrey);
    putText(panel, cv::format("%.0f", searchers), place(searchers, 1.0) + cv::Point(-12, 18));
  }
  putText(panel, "iterations to 0.01 (mean of all runs) over number of searchers",
          {kLeft, kHeight - 12}, 0.44);
}

cv::Mat draw(const std::string& function, const std::vector<SwarmRaceCell>& cells) {
  cv::Mat panel(kHeight, kWidth, CV_8UC3, kWhite);
  drawAxes(panel, function);
  std::vector<std::string> moves;
  std::map<std::string, std::vector<cv::Point>> curves;
  for (const SwarmRaceCell& cell : cells) {
    if (cell.function != function) continue;
    if (!curves.count(cell.move)) moves.push_back(cell.move);
    curves[cell.move].push_back(place(cell.searchers, cell.iterations()));
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const cv::Scalar colour = curveColour(i);
    cv::polylines(panel, curves[moves[i]], false, colour, 2, cv::LINE_AA);
    const cv::Point at(kWidth - kRight + 14, kTop + 14 + 20 * static_cast<int>(i));
    cv::line(panel, at - cv::Point(0, 5), at + cv::Point(24, -5), colour, 3, cv::LINE_AA);
    putText(panel, moves[i], at + cv::Point(32, 0));
  }
  return panel;
}

}  // namespace

void savePlot(const std::vector<SwarmRaceCell>& cells, const std::string& file) {
  std::vector<std::string> functions;
  for (const SwarmRaceCell& cell : cells) {
    if (functions.empty() || functions.back() != cell.function) functions.push_back(cell.function);
  }
  std::vector<cv::Mat> panels;
  for (const std::string& function : functions) panels.push_back(draw(function, cells));
  if (panels.empty()) panels.emplace_back(kHeight, kWidth, CV_8UC3, kWhite);
  saveImage(tiled(panels, kPanelsInRow), "plot", file);
}

}  // namespace adaptive_localization
