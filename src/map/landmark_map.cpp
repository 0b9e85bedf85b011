// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/landmark_map.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "landmark_list.hpp"

namespace adaptive_localization {
namespace {

[[noreturn]] void reject(std::size_t entry, const std::string& expected) {
  throw std::invalid_argument("'landmarks[" + std::to_string(entry) + "]': expected " + expected);
}

Landmark read(const YAML::Node& node, std::size_t entry) {
  const std::string form = "{id: whole number from 0 on, at: [x, y] in metres}";
  if (!node.IsMap() || node.size() != 2 || !node["id"] || !node["at"]) reject(entry, form);
  Landmark landmark;
  landmark.id = node["id"].as<int>(-1);
  if (landmark.id < 0) reject(entry, form);
  const YAML::Node& at = node["at"];
  if (!at.IsSequence() || at.size() != 2) reject(entry, form);
  for (int axis = 0; axis < 2; ++axis) {
    landmark.place[axis] = at[axis].as<double>(NAN);
    if (!(std::abs(landmark.place[axis]) < 1e4)) reject(entry, form);
  }
  return landmark;
}

}  // namespace

LandmarkMap::LandmarkMap(std::vector<Landmark> all) : all_(std::move(all)) {}

std::vector<Eigen::Vector2d> LandmarkMap::candidates(int id) const {
  std::vector<Eigen::Vector2d> places;
  for (const Landmark& landmark : all_) {
    if (id < 0 || landmark.id == id) places.push_back(landmark.place);
  }
  return places;
}

std::vector<Landmark> readLandmarks(const YAML::Node& list) {
  if (!list || !list.IsSequence() || list.size() == 0) {
    throw std::invalid_argument("'landmarks': expected a list with one landmark or more");
  }
  std::vector<Landmark> all;
  for (std::size_t i = 0; i < list.size(); ++i) all.push_back(read(list[i], i));
  return all;
}

LandmarkMap loadLandmarks(const std::string& yaml_file) {
  try {
    const YAML::Node root = YAML::LoadFile(yaml_file);
    return LandmarkMap(readLandmarks(root.IsMap() ? root["landmarks"] : YAML::Node()));
  } catch (const std::exception& error) {
    throw std::invalid_argument("landmark map '" + yaml_file + "': " + error.what());
  }
}

}  // namespace adaptive_localization
