// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "canvas.hpp"
#include "eval/sonar_map_picture.hpp"
#include "map/evidence_models.hpp"

namespace adaptive_localization {
namespace {

constexpr int kWidth = 620, kHeight = 300;                       // px, of a panel
constexpr int kLeft = 52, kRight = 20, kTop = 40, kBottom = 50;  // px around the axes
constexpr double kDegree = kPi / 180.0;
const cv::Scalar kGrey(220, 220, 220), kWhite(255, 255, 255);

/// From left to right, and probabilities upwards.
struct Axes {
  double low, high;  // m or degrees

  cv::Point place(double across, double probability) const {
    const double right = (across - low) / (high - low);
    return {kLeft + static_cast<int>(std::lround((kWidth - kLeft - kRight) * right)),
            kHeight - kBottom -
                static_cast<int>(std::lround((kHeight - kTop - kBottom) * probability))};
  }
};

/// A cell's probability after one reading, by its distance, m, and its bearing from the axis, rad.
class OneReading {
 public:
  OneReading(std::string model, const EvidenceOptions& options, const SonarReading& sonar,
             double resolution)
      : model_(std::move(model)), options_(options), sonar_(sonar), resolution_(resolution) {
    options_.evidence_reach = sonar.max_range;  // long ones too
  }

  /// On a lattice that has the middle of a cell just there, on the x axis, and all of the cone.
  double probability(double range, double distance, double bearing) const {
    const int half = static_cast<int>(std::ceil(1.1 * sonar_.max_range / resolution_)) + 1;
    const double corner = -(half + 0.5) * resolution_;
    const Lattice lattice(2 * half + 1, 2 * half + 1, resolution_,
                          {distance + corner, corner, 0.0});
    const auto grid = makeEvidenceGrid(model_, lattice, options_);
    SonarReading reading = sonar_;
    reading.T_base_sonar = {};
    reading.range = range;
    grid->add({0.0, 0.0, -bearing}, reading);
    return grid->probability({half, half});
  }

 private:
  std::string model_;
  EvidenceOptions options_;
  SonarReading sonar_;
  double resolution_;
};

cv::Mat drawAxes(const Axes& axes, double step, const std::string& title, const std::string& what) {
  cv::Mat panel(kHeight, kWidth, CV_8UC3, kWhite);
  putText(panel, title, {kLeft, 26}, 0.6);
  for (const double probability : {0.0, 0.5, 1.0}) {
    cv::line(panel, axes.place(axes.low, probability), axes.place(axes.high, probability), kGrey);
    putText(panel, cv::format("%.1f", probability), {12, axes.place(axes.low, probability).y + 5});
  }
  for (double at = axes.low; at < axes.high + step / 2.0; at += step) {
    cv::line(panel, axes.place(at, 0.0), axes.place(at, 1.0), kGrey);
    putText(panel, cv::format("%g", at), axes.place(at, 0.0) + cv::Point(-8, 18));
  }
  putText(panel, what, {kLeft, kHeight - 10}, 0.44);
  return panel;
}

void drawLegend(cv::Mat& panel, const std::vector<double>& ranges) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const cv::Point at(kWidth - kRight - 86 * static_cast<int>(ranges.size() - i), 26);
    cv::line(panel, at - cv::Point(0, 5), at + cv::Point(24, -5), curveColour(i), 3, cv::LINE_AA);
    putText(panel, cv::format("%g m", ranges[i]), at + cv::Point(32, 0));
  }
}

cv::Mat drawAlong(const std::string& model, const OneReading& one,
                  const std::vector<double>& ranges, double max_range) {
  constexpr double kStep = 0.01;  // m
  const Axes axes{0.0, std::ceil(max_range)};
  cv::Mat panel = drawAxes(axes, 1.0, model, "probability on the axis over the distance, m");
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    std::vector<cv::Point> curve;
    for (double distance = kStep; distance < max_range; distance += kStep) {
      curve.push_back(axes.place(distance, one.probability(ranges[i], distance, 0.0)));
    }
    cv::polylines(panel, curve, false, curveColour(i), 2, cv::LINE_AA);
  }
  drawLegend(panel, ranges);
  return panel;
}

/// Across the arc of the reading, solid, and across the middle before it, thin.
cv::Mat drawAcross(const std::string& model, const OneReading& one,
                   const std::vector<double>& ranges, double view) {
  constexpr double kStep = 0.5;  // degrees
  const double side = 5.0 * std::ceil(0.5 * view / kDegree / 5.0 + 0.5);
  const Axes axes{-side, side};
  cv::Mat panel = drawAxes(
      axes, 5.0, model, "probability over the bearing, degrees: on the arc, and half way (thin)");
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    for (const bool is_arc : {false, true}) {
      std::vector<cv::Point> curve;
      for (double bearing = -side; bearing <= side; bearing += kStep) {
        const double distance = is_arc ? ranges[i] : 0.5 * ranges[i];
        curve.push_back(
            axes.place(bearing, one.probability(ranges[i], distance, bearing * kDegree)));
      }
      cv::polylines(panel, curve, false, curveColour(i), is_arc ? 2 : 1, cv::LINE_AA);
    }
  }
  drawLegend(panel, ranges);
  return panel;
}

}  // namespace

void saveProfiles(const std::vector<std::string>& models, const EvidenceOptions& options,
                  const SonarReading& sonar, double resolution, const std::string& file) {
  std::vector<double> ranges;
  for (double range = 1.0; range < sonar.max_range && ranges.size() < 5; range += 1.0) {
    ranges.push_back(range);
  }
  std::vector<cv::Mat> panels;
  for (const std::string& model : models) {
    const OneReading one(model, options, sonar, resolution);
    panels.push_back(drawAlong(model, one, ranges, sonar.max_range));
    panels.push_back(drawAcross(model, one, ranges, sonar.view));
  }
  saveImage(tiled(panels, 2), "picture", file);
}

}  // namespace adaptive_localization
