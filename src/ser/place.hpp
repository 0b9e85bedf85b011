// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// A place where a scan can have been taken.
struct Place {
  Pose2 T_map_base;
  double error{0.0};  // mean truncated range error per beam, m
};

inline bool fitsBetter(const Place& a, const Place& b) {
  return a.error < b.error;
}

constexpr double kSamePlace = 0.5;  // m

/// Nearer than half a metre and 20 degrees.
bool areSamePlace(const Pose2& a, const Pose2& b);

/// The first of each group of places that are one.
std::vector<Place> distinctPlaces(const std::vector<Place>& places);

}  // namespace adaptive_localization
