// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>

#include "canvas.hpp"
#include "eval/line_drive.hpp"

namespace adaptive_localization {
namespace {

constexpr double kSurroundings = 1.5;  // m
constexpr double kLeastStep = 2.0;     // m between ellipses

const cv::Scalar kTruth(60, 160, 60), kOdometry(40, 40, 210), kLines(190, 90, 20);  // b, g, r
const cv::Scalar kHit(120, 120, 120), kMapLine(40, 170, 250), kSeen(0, 0, 0);
const cv::Scalar kUnknown(200, 60, 200);

std::vector<Pose2> placesOf(const Segment& segment) {
  return {{segment.a.x(), segment.a.y(), 0.0}, {segment.b.x(), segment.b.y(), 0.0}};
}

/// The steps with ellipses: so many metres apart.
std::vector<LineDriveStep> stopsOf(const LineDrive& drive) {
  const double every = std::max(kLeastStep, drive.steps.back().driven / 8.0);
  std::vector<LineDriveStep> stops;
  for (const auto& step : drive.steps) {
    if (stops.empty() || step.driven >= stops.back().driven + every) stops.push_back(step);
  }
  return stops;
}

struct Ways {
  std::vector<Pose2> truth, odometry, lines;

  explicit Ways(const std::vector<LineDriveStep>& steps) {
    for (const auto& step : steps) {
      truth.push_back(step.T_map_base);
      odometry.push_back(step.odometry.mean);
      lines.push_back(step.lines.mean);
    }
  }
};

/// All that the picture is to show; ellipses of odometry alone may end beyond it.
std::vector<Pose2> shownOf(const LineDrive& drive, const Ways& ways) {
  std::vector<Pose2> shown;
  for (const auto* way : {&ways.truth, &ways.odometry, &ways.lines}) {
    shown.insert(shown.end(), way->begin(), way->end());
  }
  for (const auto& line : drive.seen) {
    for (const auto& end : placesOf(line.segment)) shown.push_back(end);
  }
  for (const auto& stop : stopsOf(drive)) {
    for (const auto& point : ellipse(stop.lines)) shown.push_back(point);
  }
  return shown;
}

void drawScan(Canvas& canvas, const LineDrive& drive) {
  for (const auto& hit : drive.hits) canvas.drawDot({hit.x(), hit.y(), 0.0}, kHit, 3);
  for (const auto& wall : drive.matched) canvas.drawPath(placesOf(wall), kMapLine, 9);
  for (const auto& line : drive.seen) {
    canvas.drawPath(placesOf(line.segment), line.is_matched ? kSeen : kUnknown, 3);
  }
}

void drawWays(Canvas& canvas, const LineDrive& drive, const Ways& ways) {
  canvas.drawPath(ways.truth, kTruth, 7);
  canvas.drawPath(ways.odometry, kOdometry, 2);
  canvas.drawPath(ways.lines, kLines, 2);
  for (const auto& stop : stopsOf(drive)) {
    canvas.drawPath(ellipse(stop.odometry), kOdometry, 1);
    canvas.drawPath(ellipse(stop.lines), kLines, 2);
  }
}

std::vector<std::string> captionOf(const LineDriveStep& last) {
  return {
      cv::format("%.0f s, %.1f m; ellipses of 99 %%", last.stamp, last.driven),
      cv::format("odometry is off by %.2f m at the end,",
                 distance(last.T_map_base, last.odometry.mean)),
      cv::format("the filter with lines by %.3f m", distance(last.T_map_base, last.lines.mean))};
}

}  // namespace

void savePlot(const LineDrive& drive, const std::string& file) {
  const Ways ways(drive.steps);
  Canvas canvas(*drive.map, shownOf(drive, ways), kSurroundings);
  canvas.drawMap(*drive.map);
  drawScan(canvas, drive);
  drawWays(canvas, drive, ways);
  canvas.drawDot(ways.truth.front(), kTruth);
  canvas.drawScaleBar();
  canvas.drawLegend({{"truth", kTruth},
                     {"odometry alone", kOdometry},
                     {"corrected by lines", kLines},
                     {"map's line, matched", kMapLine},
                     {"scan's line, matched", kSeen},
                     {"scan's line, not matched", kUnknown}},
                    captionOf(drive.steps.back()));
  saveImage(canvas.image(), "plot", file);
}

}  // namespace adaptive_localization
