// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "swarm/swarm_move.hpp"

namespace adaptive_localization {

void ParticleSwarmMove::step(Swarm& swarm, const Objective& objective, Rng& rng) const {
  constexpr double kInertia = 0.7298, kPull = 1.4962, kFastest = 0.2;
  const SearchSpace& space = swarm.space;
  for (Eigen::Index i = 0; i < swarm.size(); ++i) {
    for (Eigen::Index k = 0; k < space.dimensions(); ++k) {
      double& x = swarm.position(i, k);
      double& v = swarm.velocity(i, k);
      v = kInertia * v + kPull * rng.uniform() * space.way(k, x, swarm.own_best(i, k)) +
          kPull * rng.uniform() * space.way(k, x, swarm.best[k]);
      v = std::clamp(v, -kFastest * space.width(k), kFastest * space.width(k));
      x = space.inside(k, x + v);
    }
  }
  objective.evaluate(swarm.position, swarm.cost);
  for (Eigen::Index i = 0; i < swarm.size(); ++i) {
    if (!(swarm.cost[i] < swarm.own_best_cost[i])) continue;
    swarm.own_best_cost[i] = swarm.cost[i];
    swarm.own_best.row(i) = swarm.position.row(i);
  }
  swarm.note(swarm.position, swarm.cost);
  ++swarm.iteration;
}

}  // namespace adaptive_localization
