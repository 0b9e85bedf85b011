// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "swarm/swarm_move.hpp"

namespace adaptive_localization {

/// When a search ends: whichever comes first.
struct StopRule {
  double tolerance{0.0};  // cost that is good enough
  int max_iterations{500};
  double max_evaluations{1e9};  // of the objective, the first ones of the swarm among them
  int patience{0};              // iterations without progress; 0: any number
};

struct SearchResult {
  int iterations{0};
  bool is_reached{false};  // the tolerance
};

/// Moves a swarm until the rule says so.
SearchResult search(Swarm& swarm, const SwarmMove& move, const Objective& objective,
                    const StopRule& rule, Rng& rng);

}  // namespace adaptive_localization
