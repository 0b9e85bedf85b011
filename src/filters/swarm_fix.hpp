// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "adaptive_localization/filter.hpp"
#include "adaptive_localization/ser/places.hpp"
#include "adaptive_localization/swarm/range_objective.hpp"
#include "adaptive_localization/swarm/swarm_move.hpp"

namespace adaptive_localization {

struct SwarmFixOptions {
  std::string swarm_ranges{"table"};
  int swarm_polish_beams{90};
  double swarm_tolerance{0.0};
  int swarm_max_iterations{60};
  int swarm_patience{6};
  double swarm_budget{2.0};
  bool wrap_map{false};

  template <class Visitor>
  void visit(Visitor&& option) {
    option(
        "swarm_ranges", swarm_ranges, Choices{"table", "cast"},
        "Where expected ranges come from: the energy grid's table, once it is made, or exact ray "
        "casting.");
    option("swarm_polish_beams", swarm_polish_beams, Range{0, 10000}, "",
           "Beams for a last, local search by exact ray casting round the best place; 0: none.");
    option("swarm_tolerance", swarm_tolerance, kNotNegative, "m, 1",
           "Cost that is good enough to end a search.");
    option("swarm_max_iterations", swarm_max_iterations, Range{1, 1000000}, "",
           "Iterations of a search at the most.");
    option("swarm_patience", swarm_patience, kNotNegative, "",
           "Iterations without progress that end a search; 0: any number.");
    option(
        "swarm_budget", swarm_budget, kPositive, "",
        "Millions of ranges looked up in a search at the most; a ray that is cast counts as 30.");
    option("wrap_map", wrap_map, "The map's ends are joined: swarms search a torus.");
  }
};

/// What a swarm found.
struct SwarmFix {
  Estimate estimate;
  double cost;
  int iterations;
  Particles bats;     // weighed by their cost
  Particles leaders;  // of the bats
};

/// Lets a swarm loose on a scan.
class SwarmFixer {
 public:
  SwarmFixer(const SwarmFixOptions& options, const RangeObjectiveOptions& objective,
             const std::optional<LeaderOptions>& leaders, double max_range,
             std::shared_ptr<const OccupancyGrid> map, std::shared_ptr<Places> places);

  /// The best poses for a scan, from these on, all over the map or not far from them.
  SwarmFix fix(const Particles& start, bool is_anywhere, const SwarmMove& move,
               const Observations& observations, Rng& rng);

  /// The same pose, on a torus between the map's ends.
  Pose2 inMap(const Pose2& T_map_base) const;

  /// The cost of a pose.
  double costOf(const Pose2& T_map_base, const Observations& observations);

  /// The largest cost there is.
  double worst() const;

 private:
  std::unique_ptr<RangeObjective> objectiveFor(const Observations& observations);
  SearchSpace spaceAround(const Eigen::ArrayXXd& positions) const;
  void polish(const SwarmMove& move, const Scan& scan, SwarmFix& fix, Rng& rng) const;

  SwarmFixOptions options_;
  RangeObjectiveOptions objective_;
  std::optional<LeaderOptions> leaders_;  // of swarms that have such
  double max_range_;
  std::shared_ptr<const OccupancyGrid> map_;
  std::shared_ptr<Places> places_;
  std::shared_ptr<const EnergyGrid> grid_;
  std::shared_ptr<const RangeRows> rows_;  // of grid_
  SearchSpace whole_;
};

}  // namespace adaptive_localization
