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

/// The bat algorithm as printed, with the right sign and improved, the leader-based one as printed,
/// improved and without its leaps along one axis, and the particle swarm.
std::vector<SwarmRacer> swarmRacers();

/// Fixes from one kind of start by one kind of swarm, or filter, of one size.
struct SwarmFixCell {
  std::string start, core;
  int searchers{0};
  int runs{0};
  int reached{0};                 // the tolerance
  int found{0};                   // within 0.15 m and 5 degrees
  std::vector<int> iterations{};  // of each run, by seed; of a filter: updates
  double error_mm{0.0};           // mean of those found
  double matched_mm{0.0};       // mean of the same, once the scan is matched with the plan's walls
  double matched_std_mm{0.0};   // standard deviation of these
  double matched_ic99_mm{0.0};  // half the 99 % interval of their mean, 2.58 sigma / sqrt(n)
  double ms_median{0.0}, ms_mean{0.0};  // of all runs

  double meanIterations() const;
};

struct SwarmFixPlan {
  std::string world;        // YAML file of a floor plan
  double resolution{0.05};  // m, of the map
  int runs{30};
  int first_seed{1};
  std::vector<int> searchers{20, 400, 800, 1200, 1600, 2000};
  std::vector<std::string> starts{"free", "ser", "places"};  // as the option `elsewhere`
  std::vector<std::string> filters{"lbba", "ba", "pso", "amcl", "sa_kld"};
  bool is_torus{false};
};

/// Experiments E8 to E11: a laser that stands anywhere, scans of 11 beams with 31 mm of noise, and
/// searchers that are the same for all kinds of swarms: spread over all free space, over the scan's
/// SER, or round the places of the global search, which look at all beams. It ends at 3 per cent of
/// mean relative deviation or after 500 iterations. Filters that may start anywhere are updated
/// with scan after scan from the same place, until their estimate is as good; swarms among them
/// match scans with the plan's walls. On one thread; what is made once for a map is not timed.
std::vector<SwarmFixCell> raceFixes(const SwarmFixPlan& plan);

/// In Markdown; at the end, for each start and number, how likely the improved leaders need fewer
/// iterations than the bats with the right sign by chance only.
std::string toTable(const std::vector<SwarmFixCell>& cells);

}  // namespace adaptive_localization
