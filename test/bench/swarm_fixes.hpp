// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "bench/swarm_racers.hpp"

namespace adaptive_localization {

/// What came of one search.
struct SwarmFixRun {
  int seed{0};
  int iterations{0};       // of a filter: updates
  double cost{0.0};        // at the end, of the answer: the mean relative deviation of 11 beams
  bool is_reached{false};  // the tolerance
  bool is_found{false};    // within 0.15 m and 5 degrees
  double error_mm{0.0};    // of position
  double matched_mm{0.0};  // the same, once the scan is matched with the plan's walls
  double ms{0.0};
};

/// Fixes from one kind of start by one kind of swarm, or filter, of one size.
struct SwarmFixCell {
  std::string start, core;
  int searchers{0};
  std::vector<SwarmFixRun> runs{};  // by seed

  int found() const;
  std::vector<SwarmFixRun> foundRuns() const;
  double meanIterations() const;
};

struct SwarmFixPlan {
  std::string world;        // YAML file of a floor plan
  double resolution{0.05};  // m, of the map
  double noise{0.031};      // m, standard deviation of a range
  int runs{30};
  int first_seed{1};
  std::vector<int> searchers{20, 400, 800, 1200, 1600, 2000};
  std::vector<std::string> starts{"free", "ser", "places"};  // as the option `elsewhere`
  /// With the recommended preset, or another after a slash: lbba/seed.
  std::vector<std::string> filters{"lbba", "ba", "pso", "amcl", "sa_kld"};
  Parameters options;  // of the filters
  std::vector<std::string> swarms{swarmNames()};
  int updates{500};  // of a filter, at the most
  bool is_torus{false};
};

/// Experiments E8 to E11: a laser that stands anywhere, scans of 11 beams with noise, and
/// searchers that are the same for all kinds of swarms: spread over all free space, over the scan's
/// SER, or round the places of the global search, which look at all beams. It ends at 3 per cent of
/// mean relative deviation or after 500 iterations. Filters that may start anywhere are updated
/// with scan after scan from the same place, until their estimate is as good; swarms among them
/// match scans with the plan's walls. On one thread; what is made once for a map is not timed.
std::vector<SwarmFixCell> raceFixes(const SwarmFixPlan& plan);

/// A list of objects of start, core, searchers and runs, with SwarmFixRun's members.
/// Throws std::runtime_error naming the file.
void saveJson(const std::vector<SwarmFixCell>& cells, const std::string& file);

}  // namespace adaptive_localization
