// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/swarm.hpp"

#include <limits>

namespace adaptive_localization {

Swarm::Swarm(SearchSpace where, const Eigen::ArrayXXd& positions, const Objective& objective)
    : space(std::move(where)),
      position(positions),
      velocity(Eigen::ArrayXXd::Zero(positions.rows(), positions.cols())),
      cost(Eigen::ArrayXd::Zero(positions.rows())),
      loudness(Eigen::ArrayXd::Ones(positions.rows())),
      rate(Eigen::ArrayXd::Zero(positions.rows())),
      best(positions.row(0)),
      best_cost(std::numeric_limits<double>::infinity()) {
  objective.evaluate(position, cost);
  own_best = position;
  own_best_cost = cost;
  note(position, cost);
}

void Swarm::note(const Eigen::ArrayXXd& positions, const Eigen::ArrayXd& costs) {
  Eigen::Index i = 0;
  if (!(costs.minCoeff(&i) < best_cost)) return;
  best_cost = costs[i];
  best = positions.row(i);
}

Eigen::ArrayXXd spreadOver(const SearchSpace& space, Eigen::Index count, Rng& rng) {
  Eigen::ArrayXXd positions(count, space.dimensions());
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < space.dimensions(); ++k) {
      positions(i, k) = rng.uniform(space.low[k], space.high[k]);
    }
  }
  return positions;
}

}  // namespace adaptive_localization
