// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/swarm_search.hpp"

namespace adaptive_localization {

SearchResult search(Swarm& swarm, const SwarmMove& move, const Objective& objective,
                    const StopRule& rule, Rng& rng) {
  constexpr double kProgress = 0.99;  // of the best cost
  SearchResult result;
  const auto per_iteration = static_cast<double>(swarm.size());
  double evaluations = per_iteration;  // the first ones of the swarm
  double best_before = swarm.best_cost;
  int idle = 0;
  while (!(result.is_reached = swarm.best_cost <= rule.tolerance)) {
    evaluations += per_iteration;
    if (result.iterations >= rule.max_iterations || evaluations > rule.max_evaluations) break;
    if (rule.patience > 0 && idle >= rule.patience) break;
    move.step(swarm, objective, rng);
    ++result.iterations;
    idle = swarm.best_cost < kProgress * best_before ? 0 : idle + 1;
    if (idle == 0) best_before = swarm.best_cost;
  }
  return result;
}

}  // namespace adaptive_localization
