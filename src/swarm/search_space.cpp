// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/swarm/search_space.hpp"

#include <algorithm>
#include <cmath>

#include "adaptive_localization/pose2.hpp"

namespace adaptive_localization {

bool SearchSpace::wraps(Eigen::Index k) const {
  const bool is_heading = has_heading && k == dimensions() - 1;
  return is_heading ? width(k) > 2.0 * kPi - 1e-9 : is_torus;
}

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
