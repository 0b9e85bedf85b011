// SPDX-License-Identifier: BSD-3-Clause
#include "map/landmark_file.hpp"

#include <stdexcept>

#include "landmark_list.hpp"

namespace adaptive_localization {

LandmarkMap loadLandmarks(const std::string& yaml_file) {
  try {
    const YAML::Node root = YAML::LoadFile(yaml_file);
    return LandmarkMap(readLandmarks(root.IsMap() ? root["landmarks"] : YAML::Node()));
  } catch (const std::exception& error) {
    throw std::invalid_argument("landmark map '" + yaml_file + "': " + error.what());
  }
}

}  // namespace adaptive_localization
