// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/floor_plan.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "landmark_list.hpp"

namespace adaptive_localization {
namespace {

using Numbers = std::vector<double>;

const char* const kKeys[] = {"outline",   "wall_thickness", "walls", "solids",
                             "furniture", "route",          "start", "landmarks"};

[[noreturn]] void reject(const std::string& key, const std::string& expected) {
  throw std::invalid_argument("'" + key + "': expected " + expected);
}

void rejectUnknownKeys(const YAML::Node& root) {
  std::string known;
  for (const char* key : kKeys) known += (known.empty() ? "" : ", ") + std::string(key);
  for (const auto& entry : root) {
    const auto key = entry.first.as<std::string>();
    if (std::find(std::begin(kKeys), std::end(kKeys), key) == std::end(kKeys)) {
      reject(key, "one of " + known);
    }
  }
}

Numbers numbers(const YAML::Node& node, const std::string& key, std::size_t count,
                const std::string& expected) {
  Numbers values;
  try {
    values = node.as<Numbers>();
  } catch (const YAML::Exception&) {
    reject(key, expected);
  }
  bool good = values.size() == count;
  for (const double value : values) good = good && std::abs(value) < 1e4;  // NaN fails too
  if (!good) reject(key, expected);
  return values;
}

std::vector<Eigen::Vector2d> points(const YAML::Node& node, const std::string& key,
                                    std::size_t at_least) {
  const std::string expected =
      "a list of at least " + std::to_string(at_least) + " points [x, y] in metres";
  if (!node.IsSequence() || node.size() < at_least) reject(key, expected);
  std::vector<Eigen::Vector2d> result;
  for (const auto& entry : node) {
    const Numbers xy = numbers(entry, key, 2, expected);
    result.emplace_back(xy[0], xy[1]);
  }
  return result;
}

/// Twice the area, negative if the corners go round clockwise. m^2
double doubleArea(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Eigen::Vector2d a = polygon[i - 1] - polygon[0];
    const Eigen::Vector2d b = polygon[i] - polygon[0];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

std::vector<std::vector<Eigen::Vector2d>> lists(const YAML::Node& root, const std::string& key,
                                                std::size_t at_least) {
  std::vector<std::vector<Eigen::Vector2d>> result;
  if (!root[key]) return result;
  if (!root[key].IsSequence()) reject(key, "a list of lists of points");
  for (const auto& entry : root[key]) result.push_back(points(entry, key, at_least));
  return result;
}

FloorPlan parse(const YAML::Node& root) {
  constexpr double kLeastArea = 1e-6;  // m^2
  if (root.IsMap()) rejectUnknownKeys(root);
  if (!root.IsMap() || !root["outline"]) reject("outline", "a polygon of at least 3 points");
  FloorPlan plan;
  plan.outline = points(root["outline"], "outline", 3);
  if (!(std::abs(doubleArea(plan.outline)) > kLeastArea)) {
    reject("outline", "points round an area, not on one line");
  }
  if (const auto thickness = root["wall_thickness"]) {
    plan.wall_thickness = thickness.as<double>(-1.0);
    if (!(plan.wall_thickness > 0.0 && plan.wall_thickness < 10.0)) {
      reject("wall_thickness", "a number of metres in (0, 10)");
    }
  }
  for (const auto& line : lists(root, "walls", 2)) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i - 1] == line[i]) reject("walls", "no point twice in a row");
      plan.walls.push_back({line[i - 1], line[i]});
    }
  }
  plan.solids = lists(root, "solids", 3);
  plan.furniture = lists(root, "furniture", 3);
  if (root["landmarks"]) plan.landmarks = readLandmarks(root["landmarks"]);
  if (root["route"]) plan.route = points(root["route"], "route", 1);
  if (root["start"]) {
    const Numbers start = numbers(root["start"], "start", 3, "[x, y, yaw] in metres and radians");
    plan.start = Pose2{start[0], start[1], start[2]};
  }
  return plan;
}

}  // namespace

FloorPlan loadFloorPlan(const std::string& yaml_file) {
  try {
    return parse(YAML::LoadFile(yaml_file));
  } catch (const std::exception& error) {
    throw std::invalid_argument("floor plan '" + yaml_file + "': " + error.what());
  }
}

std::vector<Polygon> solidsOf(const FloorPlan& plan) {
  std::vector<Polygon> solids = plan.solids;
  for (const auto& wall : plan.walls) solids.push_back(thickLine(wall, plan.wall_thickness));
  return solids;
}

bool isFree(const Polygon& outline, const std::vector<Polygon>& solids,
            const Eigen::Vector2d& point) {
  return contains(outline, point) &&
         std::none_of(solids.begin(), solids.end(),
                      [&](const Polygon& solid) { return contains(solid, point); });
}

}  // namespace adaptive_localization
