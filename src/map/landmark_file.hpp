// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "map/landmark_map.hpp"

namespace adaptive_localization {

/// Reads the list `landmarks` of a YAML file, which may be a floor plan:
///
///     landmarks:
///       - {id: 0, at: [4.5, 0.8]}       # m, in the map
///       - {id: 0, at: [4.5, -0.8]}      # looks the same
///       - {id: 1, at: [0.0, 2.0], reflector: 0.1}    # m, its width; see sim/laser.hpp
///
/// Throws std::invalid_argument naming the file, the entry and what was expected.
LandmarkMap loadLandmarks(const std::string& yaml_file);

}  // namespace adaptive_localization
