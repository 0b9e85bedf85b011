// SPDX-License-Identifier: BSD-3-Clause
#include "experiment_values.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;
constexpr double kDegree = kPi / 180.0;
constexpr Range kSeconds{0.0, 1e6};

/// A path as the experiment's file means it: from its own place.
std::string resolve(const YamlValue& value) {
  const fs::path path = fs::path(value.file()).parent_path() / value.text();
  if (!fs::exists(path)) value.reject("a file or folder that exists, from the place of this file");
  return path.lexically_normal().string();
}

std::vector<Eigen::Vector2d> readRoute(const YamlValue& value) {
  std::vector<Eigen::Vector2d> route;
  if (value.node().IsScalar()) {
    value.oneOf({"random"});
    return route;
  }
  const std::string expected = "random, or a list of points [x, y] in metres";
  for (const auto& point : value.list(expected)) {
    const auto xy = point.numbers(2, "a point [x, y] in metres");
    route.emplace_back(xy[0], xy[1]);
  }
  return route;
}

Parameters readSimulation(const YamlValue& value) {
  Parameters parameters = value.parameters();
  for (const char* key : {"world", "start", "seed"}) {
    if (parameters.has(key)) value.at(key).reject("nothing here: the experiment sets it");
  }
  try {
    SimulationOptions::from(parameters);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("file '" + value.file() + "': '" + value.key() +
                                "': " + error.what());
  }
  for (const auto& key : parameters.unknownKeys()) {
    value.at(key).reject("a key that p3dx_simulator knows");
  }
  return parameters;
}

void readOffset(const YamlValue& value, WrongStart& told) {
  if (!value.node().IsSequence()) {
    told.off_by = value.number({0.0, 1e4});
    return;
  }
  const auto xy = value.numbers(2, "a number of metres, or [x, y] in metres");
  told.shift = Eigen::Vector2d(xy[0], xy[1]);
}

WrongStart readTold(const YamlValue& value) {
  WrongStart told;
  if (value.node().IsSequence()) {
    const auto pose = value.numbers(3, "[x, y, yaw] in metres and radians");
    told.pose = Pose2{pose[0], pose[1], pose[2]};
    return told;
  }
  value.allowOnly({"off_by", "turned_by"});
  if (value.has("off_by")) readOffset(value.at("off_by"), told);
  if (value.has("turned_by")) told.turned_by = value.at("turned_by").number({-kPi, kPi});
  return told;
}

void readRegions(const YamlValue& value, Spot& place) {
  for (const auto& entry : value.list("a list of rectangles [x, y, x, y]")) {
    const auto corners = entry.numbers(4, "a rectangle [x, y, x, y] in metres");
    const Eigen::Vector2d a(corners[0], corners[1]), b(corners[2], corners[3]);
    place.regions.push_back({a.cwiseMin(b), a.cwiseMax(b)});
  }
}

}  // namespace

void readWorld(const YamlValue& value, ExperimentCase& result) {
  const YamlValue world = value.at("world");
  result.world = result.map = resolve(world);
  if (fs::is_directory(result.world)) {
    result.map = (fs::path(result.world) / "map.yaml").string();
    result.world = (fs::path(result.world) / "world.yaml").string();
  }
  if (value.has("map")) {
    const bool is_surveyed = value.at("map").text() == "surveyed";
    result.map = is_surveyed ? "" : resolve(value.at("map"));
  }
  for (const auto& file : {result.world, result.map}) {
    if (!file.empty() && !fs::is_regular_file(file))
      world.reject("a folder with world.yaml and map.yaml, or a file");
  }
}

Spot readSpot(const YamlValue& value) {
  Spot place;
  if (value.node().IsScalar()) {
    value.oneOf({"random"});
  } else if (value.node().IsSequence()) {
    const auto pose = value.numbers(3, "random, or [x, y, yaw] in metres and radians");
    place.pose = Pose2{pose[0], pose[1], pose[2]};
  } else {
    value.allowOnly({"regions", "yaw", "farther_than"});
    if (value.has("regions")) readRegions(value.at("regions"), place);
    if (value.has("farther_than")) place.farther_than = value.at("farther_than").number({0, 1e4});
    if (value.has("yaw")) {
      const auto yaw = value.at("yaw").numbers(2, "[low, high] in radians");
      place.yaw_low = std::min(yaw[0], yaw[1]);
      place.yaw_high = std::max(yaw[0], yaw[1]);
    }
  }
  return place;
}

void readDrive(const YamlValue& value, ExperimentCase& result) {
  if (value.has("start")) result.start = readSpot(value.at("start"));
  if (value.has("start_known")) result.is_start_known = value.at("start_known").truth();
  if (value.has("told")) result.told = readTold(value.at("told"));
  if (result.told && value.has("start_known") && !result.is_start_known) {
    value.at("start_known").reject("true, or nothing, beside told");
  }
  result.is_start_known = result.is_start_known || result.told;
  if (value.has("route")) result.route = readRoute(value.at("route"));
  if (value.has("simulation")) result.simulation = readSimulation(value.at("simulation"));
  if (!result.simulation.has("drive")) result.simulation.set("drive", OptionValue(true));
  if (value.has("duration")) result.duration = value.at("duration").number({0.1, 1e6});
}

ExperimentEvent readEvent(const YamlValue& value) {
  using What = ExperimentEvent::What;
  ExperimentEvent event;
  const std::map<std::string, What> kinds{{"kidnap", What::kKidnap},
                                          {"carry", What::kCarry},
                                          {"block", What::kBlock},
                                          {"cover", What::kCover},
                                          {"disturb", What::kDisturb}};
  event.what = kinds.at(value.at("what").oneOf({"kidnap", "carry", "block", "cover", "disturb"}));
  std::set<std::string> keys{"what", "at", "every"};
  if (event.what == What::kBlock) {
    keys.insert({"for", "share", "pattern"});
    event.share = value.at("share").number(kProbability);
    if (value.has("pattern")) {
      event.is_sector = value.at("pattern").oneOf({"scattered", "sector"}) == "sector";
    }
  } else if (event.what == What::kCover) {
    keys.insert("for");
  } else if (event.what == What::kDisturb) {
    keys.insert({"for", "turned_by"});
    event.turned_by = value.at("turned_by").number({-kPi, kPi});
  } else {
    keys.insert("to");
    if (value.has("to")) event.to = readSpot(value.at("to"));
  }
  if (event.what == What::kCarry) {
    keys.insert({"for", "laser"});
    if (value.has("laser")) {
      event.is_garbage = value.at("laser").oneOf({"blocked", "garbage"}) == "garbage";
    }
  }
  value.allowOnly(keys);
  event.at = value.at("at").number(kSeconds);
  if (event.what != What::kKidnap) event.duration = value.at("for").number({0.1, 1e6});
  if (value.has("every")) event.every = value.at("every").number({event.duration + 0.1, 1e6});
  return event;
}

SuccessRule readSuccess(const YamlValue& value) {
  value.allowOnly({"position", "heading", "scans", "within", "modulo_half_turn"});
  SuccessRule rule;
  if (value.has("position")) rule.position = value.at("position").number({1e-3, 100.0});
  if (value.has("heading")) rule.heading = value.at("heading").number({1e-3, 180.0}) * kDegree;
  if (value.has("scans")) rule.scans = value.at("scans").whole({1, 1000});
  if (value.has("modulo_half_turn")) rule.is_modulo = value.at("modulo_half_turn").truth();
  if (value.has("within")) rule.within = value.at("within").number({0.0, 1e6});
  return rule;
}

Parameters readOptions(const YamlValue& value) {
  Parameters parameters = value.parameters();
  for (const char* key : kMapOptions) {
    if (!parameters.has(key)) continue;
    const YamlValue file = value.at(key);
    if (file.text() != "world") parameters.set(key, OptionValue(resolve(file)));
  }
  return parameters;
}

ExperimentCore readCore(const YamlValue& value) {
  value.allowOnly({"label", "filter", "preset", "options"});
  ExperimentCore core;
  const std::string filter = value.at("filter").text();
  core.label = value.has("label") ? value.at("label").text() : filter;
  if (value.has("options")) core.parameters = readOptions(value.at("options"));
  for (const char* key : {"filter", "preset", "seed", "threads"}) {
    if (core.parameters.has(key)) value.at("options").at(key).reject("it beside options, or not");
  }
  core.parameters.set("filter", OptionValue(filter));
  if (value.has("preset")) {
    core.parameters.set("preset",
                        OptionValue(value.at("preset").oneOf({"recommended", "seed", "fp"})));
  }
  return core;
}

}  // namespace adaptive_localization
