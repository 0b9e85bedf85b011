// SPDX-License-Identifier: BSD-3-Clause
#include "eval/sonar_map_picture.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "canvas.hpp"

namespace adaptive_localization {
namespace {

constexpr double kSurroundings = 0.6;  // m
const cv::Scalar kPath(230, 160, 60);  // blue, green, red

/// The middles of the cells that the picture is to show: all that are known, at least by a map.
std::vector<Pose2> cellsOf(const OccupancyGrid& map) {
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < map.lattice().size(); ++i) {
    const Cell cell = map.lattice().cell(i);
    if (!map.isOccupied(cell) && !map.isFree(cell)) continue;
    const Eigen::Vector2d centre = map.lattice().centre(cell);
    poses.push_back({centre.x(), centre.y(), 0.0});
  }
  return poses;
}

std::vector<std::string> captionOf(const SonarMap& map) {
  if (!map.score) return {map.model};
  return {map.model,
          cv::format("entropy %.3f bits per cell, %.1f %% of the cells correct, "
                     "F-score %.3f",
                     map.score->entropy, 100.0 * map.score->correct_share, map.score->f_score)};
}

cv::Mat draw(const SonarMap& map, const OccupancyGrid& shown, const SonarDrive& drive) {
  Canvas canvas(shown, cellsOf(shown), kSurroundings);
  canvas.drawCells(map.grid->lattice(), [&](const Cell& cell) -> std::optional<cv::Vec3b> {
    const double free = 1.0 - map.grid->probability(cell);
    const auto grey = static_cast<unsigned char>(std::lround(255.0 * free));
    return cv::Vec3b(grey, grey, grey);
  });
  canvas.drawPath(drive.path, kPath, 2);
  canvas.drawScaleBar();
  canvas.drawLegend({{"path", kPath}}, captionOf(map));
  return canvas.image();
}

cv::Mat draw(const OccupancyGrid& surfaces, const SonarDrive& drive) {
  Canvas canvas(surfaces, cellsOf(surfaces), kSurroundings);
  canvas.drawMap(surfaces);
  canvas.drawPath(drive.path, kPath, 2);
  canvas.drawScaleBar();
  canvas.drawLegend({{"path", kPath}}, {"truth"});
  return canvas.image();
}

}  // namespace

void saveMaps(const std::vector<SonarMap>& maps, const std::optional<OccupancyGrid>& surfaces,
              const SonarDrive& drive, const std::string& file) {
  constexpr int kColumns = 2;
  std::vector<cv::Mat> panels;
  const OccupancyGrid shown = surfaces ? *surfaces : maps.at(0).grid->toOccupancyGrid();
  for (const SonarMap& map : maps) panels.push_back(draw(map, shown, drive));
  if (surfaces) panels.push_back(draw(*surfaces, drive));
  cv::Mat half;
  cv::resize(tiled(panels, kColumns), half, {}, 0.5, 0.5, cv::INTER_AREA);
  saveImage(half, "picture", file);
}

}  // namespace adaptive_localization
