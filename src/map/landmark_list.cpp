// SPDX-License-Identifier: BSD-3-Clause
#include "landmark_list.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

constexpr double kWidest = 10.0;  // m

[[noreturn]] void reject(std::size_t entry, const std::string& expected) {
  throw std::invalid_argument("'landmarks[" + std::to_string(entry) + "]': expected " + expected);
}

Landmark read(const YAML::Node& node, std::size_t entry) {
  const std::string form = "{id: whole number from 0 on, at: [x, y] in metres}";
  const bool is_reflector = node.IsMap() && node["reflector"];
  if (!node.IsMap() || node.size() != (is_reflector ? 3U : 2U) || !node["id"] || !node["at"]) {
    reject(entry, form + ", with reflector: its width in metres if it is one");
  }
  Landmark landmark;
  landmark.id = node["id"].as<int>(-1);
  if (landmark.id < 0) reject(entry, form);
  const YAML::Node& at = node["at"];
  if (!at.IsSequence() || at.size() != 2) reject(entry, form);
  for (int axis = 0; axis < 2; ++axis) {
    landmark.place[axis] = at[axis].as<double>(NAN);
    if (!(std::abs(landmark.place[axis]) < 1e4)) reject(entry, form);
  }
  if (is_reflector) {
    landmark.reflector = node["reflector"].as<double>(NAN);
    if (!(landmark.reflector > 0.0 && landmark.reflector < kWidest)) {
      reject(entry, "reflector: a width in metres in (0, 10)");
    }
  }
  return landmark;
}

}  // namespace

std::vector<Landmark> readLandmarks(const YAML::Node& list) {
  if (!list || !list.IsSequence() || list.size() == 0) {
    throw std::invalid_argument("'landmarks': expected a list with one landmark or more");
  }
  std::vector<Landmark> all;
  for (std::size_t i = 0; i < list.size(); ++i) all.push_back(read(list[i], i));
  return all;
}

}  // namespace adaptive_localization
