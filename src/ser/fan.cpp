// SPDX-License-Identifier: BSD-3-Clause
#include "fan.hpp"

#include <algorithm>
#include <cmath>

#include "ser/scan_energy.hpp"

namespace adaptive_localization {

SweepDirection Fan::direction(std::size_t k) const {
  const double angle = (first + static_cast<int>(k)) * kDirectionStep;
  const double along = is_along_x ? std::cos(angle) : std::sin(angle);
  const double across = is_along_x ? std::sin(angle) : std::cos(angle);
  return {sense, std::clamp(across / std::abs(along), -1.0, 1.0)};
}

std::vector<Fan> fans() {
  std::vector<Fan> fans;
  for (int d = 0; d < kDirections; ++d) {
    const double x = std::cos(d * kDirectionStep), y = std::sin(d * kDirectionStep);
    const bool is_along_x = std::abs(x) >= std::abs(y);
    const int sense = (is_along_x ? x : y) > 0.0 ? 1 : -1;
    const bool goes_on = !fans.empty() && fans.back().is_along_x == is_along_x &&
                         fans.back().sense == sense && fans.back().count < Fan::kMost;
    if (!goes_on) fans.push_back({is_along_x, sense, d, 0});
    ++fans.back().count;
  }
  std::stable_partition(fans.begin(), fans.end(), [](const Fan& fan) { return fan.is_along_x; });
  return fans;
}

}  // namespace adaptive_localization
