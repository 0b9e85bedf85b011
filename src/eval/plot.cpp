// SPDX-License-Identifier: BSD-3-Clause
#include "eval/plot.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "canvas.hpp"

namespace adaptive_localization {
namespace {

const cv::Scalar kReferenceColour(230, 160, 60);  // blue, green, red
const cv::Scalar kEstimateColour(30, 30, 220);
const cv::Scalar kStartColour(40, 150, 40);

struct Paths {
  std::vector<Pose2> reference, estimate;
};

Paths pathsOf(const RunRecord& run) {
  Paths paths;
  for (const auto& step : run.steps) {
    paths.estimate.push_back(step.T_map_base);
    if (step.T_map_base_reference) paths.reference.push_back(*step.T_map_base_reference);
  }
  return paths;
}

std::vector<std::string> caption(const Metrics& metrics) {
  std::ostringstream scans, error;
  scans << std::fixed << std::setprecision(0) << metrics.scans << " scans, " << metrics.duration_s
        << " s, " << metrics.path_m << " m";
  if (!metrics.errors) return {scans.str(), "no reference"};
  error << std::fixed << std::setprecision(3) << "error " << metrics.errors->ate_rmse_m
        << " m rms, " << metrics.errors->ate_max_m << " m max, " << std::setprecision(2)
        << metrics.errors->heading_rmse_deg << " deg rms";
  return {scans.str(), error.str()};
}

}  // namespace

void savePlot(const OccupancyGrid& map, const RunRecord& run, const Metrics& metrics,
              const std::string& file) {
  const Paths paths = pathsOf(run);
  auto shown = paths.estimate;
  shown.insert(shown.end(), paths.reference.begin(), paths.reference.end());

  Canvas canvas(map, shown);
  canvas.drawMap(map);
  canvas.drawPath(paths.reference, kReferenceColour, 5);
  canvas.drawPath(paths.estimate, kEstimateColour, 2);
  if (!paths.estimate.empty()) canvas.drawDot(paths.estimate.front(), kStartColour);
  canvas.drawScaleBar();
  std::vector<LegendRow> rows;
  if (!paths.reference.empty()) rows.push_back({"reference", kReferenceColour});
  rows.push_back({"estimate", kEstimateColour});
  rows.push_back({"start", kStartColour});
  canvas.drawLegend(rows, caption(metrics));
  saveImage(canvas.image(), "plot", file);
}

}  // namespace adaptive_localization
