// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/swarm/search_space.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {

double SearchSpace::way(Eigen::Index k, double from, double to) const {
  const double direct = to - from;
  const double around = width(k);
  if (!wraps(k) || std::abs(direct) <= 0.5 * around) return direct;
  return std::remainder(direct, around);
}

double SearchSpace::inside(Eigen::Index k, double value) const {
  if (value >= low[k] && value <= high[k]) return value;
  if (!wraps(k)) return std::clamp(value, low[k], high[k]);
  const double turns = std::floor((value - low[k]) / width(k));
  return std::clamp(value - turns * width(k), low[k], high[k]);
}

}  // namespace adaptive_localization
