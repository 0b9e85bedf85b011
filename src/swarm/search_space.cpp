// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/search_space.hpp"

#include <algorithm>
#include <cmath>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

bool SearchSpace::wraps(Eigen::Index k) const {
  return isHeading(k) ? width(k) > 2.0 * kPi - 1e-9 : is_torus;
}

double SearchSpace::period(Eigen::Index k) const {
  return isHeading(k) ? 2.0 * kPi : width(k);
}

double SearchSpace::way(Eigen::Index k, double from, double to) const {
  const double direct = to - from;
  if (!wraps(k) || std::abs(direct) <= 0.5 * period(k)) return direct;
  return std::remainder(direct, period(k));
}

double SearchSpace::inside(Eigen::Index k, double value) const {
  if (value >= low[k] && value <= high[k]) return value;
  if (!wraps(k)) return std::clamp(value, low[k], high[k]);
  const double turns = std::floor((value - low[k]) / period(k));
  return std::clamp(value - turns * period(k), low[k], high[k]);
}

}  // namespace adaptive_localization
