// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <vector>

#include "map/landmark_map.hpp"

namespace adaptive_localization {

/// The landmarks of a YAML list, as loadLandmarks() takes them. Throws std::invalid_argument naming
/// the entry and what was expected.
std::vector<Landmark> readLandmarks(const YAML::Node& list);

}  // namespace adaptive_localization
