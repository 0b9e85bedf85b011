// SPDX-License-Identifier: BSD-3-Clause
#include "place_rows.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kNear = 0.5;  // m, that a place may move from one message to the next
constexpr double kTurn = 0.5;  // rad

bool areNear(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) < kNear && std::abs(wrapAngle(a.theta - b.theta)) < kTurn;
}

}  // namespace

void PlaceRows::update(const std::vector<NamedPlace>& places, bool are_held) {
  if (!are_held) rows_.clear();
  for (Row& row : rows_) row.is_there = false;
  for (const NamedPlace& place : places) {
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& other) {
      return are_held && !other.is_there && areNear(other.place.pose, place.pose);
    });
    if (row != rows_.end()) {
      *row = {place, true};
    } else if (rows_.size() < most_) {
      rows_.push_back({place, true});
    }
  }
}

}  // namespace adaptive_localization
