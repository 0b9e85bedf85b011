// SPDX-License-Identifier: BSD-3-Clause
#include "eval/carryings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <sstream>

#include "eval/statistics.hpp"
#include "json.hpp"

namespace adaptive_localization {
namespace {

bool isCarriedBetween(const RunStep& before, const RunStep& after) {
  if (!before.T_map_base_reference || !after.T_map_base_reference) return false;
  const Pose2 by_odometry =
      *before.T_map_base_reference * between(before.T_odom_base, after.T_odom_base);
  return !isNear(*after.T_map_base_reference, by_odometry);
}

}  // namespace

bool isNear(const Pose2& pose, const Pose2& reference) {
  return distance(pose, reference) <= kLostDistance &&
         std::abs(wrapAngle(pose.theta - reference.theta)) <= kLostHeading;
}

Carryings carryingsOf(const std::vector<RunStep>& steps) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  std::vector<double> found_after;  // each carrying, s
  double put_down_at = 0.0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const RunStep& step = steps[i];
    if (isCarriedBetween(steps[i - 1], step)) {
      found_after.push_back(kNever);
      put_down_at = step.stamp;
    }
    if (found_after.empty() || !step.T_map_base_reference) continue;
    if (!isNear(step.T_map_base, *step.T_map_base_reference)) {
      found_after.back() = kNever;
    } else if (found_after.back() == kNever) {
      found_after.back() = step.stamp - put_down_at;
    }
  }
  Carryings carryings;
  carryings.times = static_cast<int>(found_after.size());
  found_after.erase(std::remove(found_after.begin(), found_after.end(), kNever), found_after.end());
  carryings.found = static_cast<int>(found_after.size());
  if (found_after.empty()) return carryings;
  carryings.found_after_s = quantile(found_after, 0.5);
  carryings.found_after_longest_s = largest(found_after);
  return carryings;
}

std::string toText(const Carryings& carryings) {
  if (carryings.times == 0) return "";
  std::ostringstream text;
  text << "carried away " << carryings.times << " times, found after " << carryings.found;
  if (carryings.found_after_s) {
    text << std::fixed << std::setprecision(1) << " of them, within " << *carryings.found_after_s
         << " s in the median, " << *carryings.found_after_longest_s << " s at most";
  }
  return text.str() + "; ";
}

void to_json(nlohmann::json& json, const Carryings& carryings) {
  json = {{"times", carryings.times},
          {"found", carryings.found},
          {"found_after_s", carryings.found_after_s},
          {"found_after_longest_s", carryings.found_after_longest_s}};
}

}  // namespace adaptive_localization
