// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "adaptive_localization/core/rng.hpp"
#include "swarm/objective.hpp"
#include "swarm/search_space.hpp"

namespace adaptive_localization {

/// Searchers (bats, particles of a particle swarm), in columns; one searcher in each row.
struct Swarm {
  /// At rest at these positions, which are evaluated.
  Swarm(SearchSpace where, const Eigen::ArrayXXd& positions, const Objective& objective);

  Eigen::Index size() const { return position.rows(); }

  /// Takes note of the best of some positions, if it is better than any before.
  void note(const Eigen::ArrayXXd& positions, const Eigen::ArrayXd& costs);

  SearchSpace space;
  Eigen::ArrayXXd position, velocity;
  Eigen::ArrayXd cost;            // of position
  Eigen::ArrayXd loudness, rate;  // of bats: A, r
  Eigen::ArrayXXd own_best;       // of each searcher, for particle swarms
  Eigen::ArrayXd own_best_cost;
  Eigen::ArrayXd best;  // of all, ever: x*
  double best_cost;
  int iteration{0};
};

/// So many positions, uniform over a space.
Eigen::ArrayXXd spreadOver(const SearchSpace& space, Eigen::Index count, Rng& rng);

}  // namespace adaptive_localization
