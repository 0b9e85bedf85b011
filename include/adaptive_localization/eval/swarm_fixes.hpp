// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/swarm/swarm_move.hpp"

namespace adaptive_localization {

/// A kind of swarm that takes part in comparisons.
struct SwarmRacer {
  std::string name;
  std::shared_ptr<const SwarmMove> move;
};

/// The bat algorithm as printed and with the right sign, the leader-based one as printed and
/// improved, and the particle swarm.
std::vector<SwarmRacer> swarmRacers();

/// Fixes by one kind of swarm of one size.
struct SwarmFixCell {
  std::string move;
  int searchers{0};
  int runs{0};
  int found{0};            // within 0.15 m and 5 degrees
  int reached{0};          // the tolerance
  double iterations{0.0};  // mean
  double error_mm{0.0};    // mean of those found
  double ms_median{0.0};
};

struct SwarmFixPlan {
  std::string world;        // YAML file of a floor plan
  double resolution{0.05};  // m, of the map
  int runs{30};
  std::vector<int> searchers{20, 400, 800, 1200, 1600, 2000};
  bool is_torus{false};
};

/// Experiments E8 to E11: one scan of 11 beams with 31 mm of noise, taken anywhere, and a swarm
/// spread over all free space, the same for all kinds; until 3 per cent of mean relative deviation
/// or for 500 iterations. On one thread; ranges come from a table that is not timed.
std::vector<SwarmFixCell> raceFixes(const SwarmFixPlan& plan);

/// In Markdown.
std::string toTable(const std::vector<SwarmFixCell>& cells);

}  // namespace adaptive_localization
