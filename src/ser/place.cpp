// SPDX-License-Identifier: BSD-3-Clause
#include "ser/place.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {

bool areSamePlace(const Pose2& a, const Pose2& b) {
  return distance(a, b) < kSamePlace && std::abs(wrapAngle(a.theta - b.theta)) < kPi / 9.0;
}

std::vector<Place> distinctPlaces(const std::vector<Place>& places) {
  std::vector<Place> distinct;
  for (const Place& place : places) {
    const auto isSame = [&](const Place& other) {
      return areSamePlace(place.T_map_base, other.T_map_base);
    };
    if (std::none_of(distinct.begin(), distinct.end(), isSame)) distinct.push_back(place);
  }
  return distinct;
}

}  // namespace adaptive_localization
