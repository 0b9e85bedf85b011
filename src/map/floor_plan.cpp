// SPDX-License-Identifier: BSD-3-Clause
#include "map/floor_plan.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "landmark_list.hpp"

namespace adaptive_localization {
namespace {

using Numbers = std::vector<double>;

using Keys = std::vector<std::string>;

[[noreturn]] void reject(const std::string& key, const std::string& expected) {
  throw std::invalid_argument("'" + key + "': expected " + expected);
}

void rejectUnknownKeys(const YAML::Node& node, const Keys& keys, const std::string& prefix = "") {
  std::string known;
  for (const auto& key : keys) known += (known.empty() ? "" : ", ") + key;
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      reject(prefix + key, "one of " + known);
    }
  }
}

/// A number of metres, up to 10.
void readWidth(const YAML::Node& node, const std::string& key, double& width) {
  if (!node) return;
  width = node.as<double>(-1.0);
  if (!(width > 0.0 && width < 10.0)) reject(key, "a number of metres in (0, 10)");
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

std::vector<std::vector<Eigen::Vector2d>> lists(const YAML::Node& node, const std::string& key,
                                                std::size_t at_least) {
  std::vector<std::vector<Eigen::Vector2d>> result;
  if (!node) return result;
  if (!node.IsSequence()) reject(key, "a list of lists of points");
  for (const auto& entry : node) result.push_back(points(entry, key, at_least));
  return result;
}

std::vector<Segment> segments(const YAML::Node& node, const std::string& key) {
  std::vector<Segment> result;
  for (const auto& line : lists(node, key, 2)) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i - 1] == line[i]) reject(key, "no point twice in a row");
      result.push_back({line[i - 1], line[i]});
    }
  }
  return result;
}

void addCircle(const YAML::Node& node, std::vector<Segment>& lines) {
  constexpr int kSides = 64;
  const std::string key = "paint.circles", expected = "a list of circles [x, y, radius] in metres";
  const Numbers circle = numbers(node, key, 3, expected);
  if (!(circle[2] > 0.0)) reject(key, expected);
  const auto corner = [&](int i) {
    const double course = 2.0 * kPi * i / kSides;
    return Eigen::Vector2d(circle[0] + circle[2] * std::cos(course),
                           circle[1] + circle[2] * std::sin(course));
  };
  for (int i = 0; i < kSides; ++i) lines.push_back({corner(i), corner(i + 1)});
}

Paint readPaint(const YAML::Node& node) {
  const Keys keys{"line_width", "lines", "circles", "carpet"};
  if (!node.IsMap()) reject("paint", "keys and values: line_width, lines, circles, carpet");
  rejectUnknownKeys(node, keys, "paint.");
  Paint paint;
  readWidth(node["line_width"], "paint.line_width", paint.line_width);
  paint.lines = segments(node["lines"], "paint.lines");
  if (const auto circles = node["circles"]) {
    if (!circles.IsSequence()) reject("paint.circles", "a list of circles [x, y, radius]");
    for (const auto& circle : circles) addCircle(circle, paint.lines);
  }
  if (const auto carpet = node["carpet"]) {
    const Numbers corners =
        numbers(carpet, "paint.carpet", 4, "two opposite corners [x, y, x, y] in metres");
    paint.carpet = boundsOf({{corners[0], corners[1]}, {corners[2], corners[3]}});
  }
  return paint;
}

/// No beam ends on what hangs in the air or is hidden in a wall.
void checkReflectors(const FloorPlan& plan) {
  std::vector<Segment> surfaces;
  for (std::size_t i = 0; i < plan.landmarks.size(); ++i) {
    const Landmark& landmark = plan.landmarks[i];
    if (landmark.reflector == 0.0) continue;
    if (surfaces.empty()) surfaces = surfacesOf(plan);
    const bool is_seen = std::any_of(surfaces.begin(), surfaces.end(), [&](const Segment& surface) {
      return distance(surface, landmark.place) <= landmark.reflector / 2.0;
    });
    if (!is_seen) {
      reject("landmarks[" + std::to_string(i) + "]",
             "a reflector on the surface of the outline, a wall or a solid");
    }
  }
}

FloorPlan parse(const YAML::Node& root) {
  constexpr double kLeastArea = 1e-6;  // m^2
  const Keys keys{"outline", "wall_thickness", "walls", "solids",   "furniture",
                  "route",   "start",          "paint", "landmarks"};
  if (root.IsMap()) rejectUnknownKeys(root, keys);
  if (!root.IsMap() || !root["outline"]) reject("outline", "a polygon of at least 3 points");
  FloorPlan plan;
  plan.outline = points(root["outline"], "outline", 3);
  if (!(std::abs(doubleArea(plan.outline)) > kLeastArea)) {
    reject("outline", "points round an area, not on one line");
  }
  readWidth(root["wall_thickness"], "wall_thickness", plan.wall_thickness);
  plan.walls = segments(root["walls"], "walls");
  plan.solids = lists(root["solids"], "solids", 3);
  plan.furniture = lists(root["furniture"], "furniture", 3);
  if (root["paint"]) plan.paint = readPaint(root["paint"]);
  if (root["landmarks"]) plan.landmarks = readLandmarks(root["landmarks"]);
  checkReflectors(plan);
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
