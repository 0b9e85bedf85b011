// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "eval/run.hpp"

namespace adaptive_localization {

/// Further off than this the robot counts as lost.
constexpr double kLostDistance = 0.5;                // m
constexpr double kLostHeading = 20.0 * kPi / 180.0;  // rad

/// Whether a pose is not further off than that.
bool isNear(const Pose2& pose, const Pose2& reference);

/// How a run got over being carried away: where the reference leaves the odometry from one scan to
/// the next by more than kLostDistance or kLostHeading.
struct Carryings {
  int times{0};
  int found{0};  // after so many of them for good: never lost again until the next, or the end
  std::optional<double> found_after_s;          // the median of these
  std::optional<double> found_after_longest_s;  // and the longest
};

Carryings carryingsOf(const std::vector<RunStep>& steps);

/// Nothing where it was never carried, else a clause for a summary, with its semicolon.
std::string toText(const Carryings& carryings);

/// By this name the JSON library finds it.
void to_json(nlohmann::json& json, const Carryings& carryings);

}  // namespace adaptive_localization
