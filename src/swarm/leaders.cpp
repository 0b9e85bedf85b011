// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/swarm/leaders.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace adaptive_localization {

Eigen::Index numberOfLeaders(Eigen::Index bats, int bats_per_leader, int least) {
  return std::min<Eigen::Index>(bats, std::max<Eigen::Index>(least, bats / bats_per_leader));
}

std::vector<Eigen::Index> bestBats(const Swarm& swarm, Eigen::Index count) {
  std::vector<Eigen::Index> bats(static_cast<std::size_t>(swarm.size()));
  std::iota(bats.begin(), bats.end(), 0);
  const auto isBetter = [&swarm](Eigen::Index a, Eigen::Index b) {
    return swarm.cost[a] < swarm.cost[b] || (swarm.cost[a] == swarm.cost[b] && a < b);
  };
  std::partial_sort(bats.begin(), bats.begin() + count, bats.end(), isBetter);
  bats.resize(static_cast<std::size_t>(count));
  return bats;
}

std::vector<std::size_t> nearestLeaders(const Swarm& swarm,
                                        const std::vector<Eigen::Index>& leaders) {
  const Eigen::Index axes = std::min<Eigen::Index>(2, swarm.space.dimensions());
  std::vector<std::size_t> nearest(static_cast<std::size_t>(swarm.size()), 0);
  for (Eigen::Index i = 0; i < swarm.size() && leaders.size() > 1; ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t leader = 0; leader < leaders.size(); ++leader) {
      double squares = 0.0;
      for (Eigen::Index k = 0; k < axes; ++k) {
        const double d =
            swarm.space.way(k, swarm.position(i, k), swarm.position(leaders[leader], k));
        squares += d * d;
      }
      if (!(squares < least)) continue;
      least = squares;
      nearest[static_cast<std::size_t>(i)] = leader;
    }
  }
  return nearest;
}

}  // namespace adaptive_localization
