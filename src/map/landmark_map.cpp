// SPDX-License-Identifier: BSD-3-Clause
#include "map/landmark_map.hpp"

#include <utility>

namespace adaptive_localization {

LandmarkMap::LandmarkMap(std::vector<Landmark> all) : all_(std::move(all)) {}

std::vector<Eigen::Vector2d> LandmarkMap::candidates(int id) const {
  std::vector<Eigen::Vector2d> places;
  for (const Landmark& landmark : all_) {
    if (id < 0 || landmark.id == id) places.push_back(landmark.place);
  }
  return places;
}

}  // namespace adaptive_localization
