// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/leaders.hpp"

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
  const SearchSpace& space = swarm.space;
  const Eigen::Index axes = std::min<Eigen::Index>(2, space.dimensions());
  Eigen::Array2Xd places = Eigen::Array2Xd::Zero(2, static_cast<Eigen::Index>(leaders.size()));
  for (std::size_t j = 0; j < leaders.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    places.col(column).head(axes) = swarm.position.row(leaders[j]).head(axes);
  }
  Eigen::Array2d around = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  for (Eigen::Index k = 0; k < axes; ++k) {
    if (space.wraps(k)) around[k] = space.period(k);
  }
  std::vector<std::size_t> nearest(static_cast<std::size_t>(swarm.size()), 0);
  for (Eigen::Index i = 0; i < swarm.size() && leaders.size() > 1; ++i) {
    Eigen::Array2d bat = Eigen::Array2d::Zero();
    bat.head(axes) = swarm.position.row(i).head(axes);
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < places.cols(); ++j) {
      const Eigen::Array2d direct = (places.col(j) - bat).abs();
      const double squares = direct.min(around - direct).square().sum();
      if (!(squares < least)) continue;
      least = squares;
      nearest[static_cast<std::size_t>(i)] = static_cast<std::size_t>(j);
    }
  }
  return nearest;
}

}  // namespace adaptive_localization
