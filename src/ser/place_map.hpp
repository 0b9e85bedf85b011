// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "ser/place.hpp"

namespace adaptive_localization {

/// Poses by where they are, to find those nearby: a hash of squares.
class PlaceMap {
 public:
  void add(const Pose2& pose) {
    squares_[keyOf(columnOf(pose.x), columnOf(pose.y))].push_back(pose);
  }

  /// Whether one of them is the same place as a pose.
  bool hasSame(const Pose2& pose) const {
    const std::int64_t column = columnOf(pose.x), row = columnOf(pose.y);
    for (std::int64_t x = column - 1; x <= column + 1; ++x) {
      for (std::int64_t y = row - 1; y <= row + 1; ++y) {
        if (isIn(keyOf(x, y), pose)) return true;
      }
    }
    return false;
  }

 private:
  static std::int64_t columnOf(double metres) {
    return static_cast<std::int64_t>(std::floor(metres / kSamePlace));
  }
  static std::int64_t keyOf(std::int64_t column, std::int64_t row) {
    return column * (std::int64_t{1} << 32) + row;
  }

  bool isIn(std::int64_t key, const Pose2& pose) const {
    const auto square = squares_.find(key);
    if (square == squares_.end()) return false;
    for (const Pose2& other : square->second) {
      if (areSamePlace(pose, other)) return true;
    }
    return false;
  }

  std::unordered_map<std::int64_t, std::vector<Pose2>> squares_;
};

}  // namespace adaptive_localization
