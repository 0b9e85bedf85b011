// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/match/match.hpp"
#include "ser/places.hpp"
#include "swarm/field_objective.hpp"
#include "swarm/range_objective.hpp"
#include "swarm/swarm_search.hpp"
#include "swarm_price.hpp"

namespace adaptive_localization {

struct SwarmFixOptions {
  std::string swarm_ranges{"table"};
  std::string swarm_near{"hits"};
  std::string swarm_answer{"place"};
  bool swarm_match{true};
  double swarm_tolerance{0.0};
  int swarm_max_iterations{60};
  int swarm_patience{6};
  double swarm_budget{10.0};
  bool wrap_map{false};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("swarm_ranges", swarm_ranges, Choices{"table", "cast", "lines"},
           "Where expected ranges come from: the energy grid's table, once it is made, exact ray "
           "casting over the map's cells, or over the walls of line_map. Casting knows no other "
           "limit than the laser's range.");
    option("swarm_near", swarm_near, Choices{"hits", "ranges"},
           "What the swarm makes small near where odometry says the robot is: the mean distance of "
           "hits from the map's walls, or what it makes small everywhere.");
    option("swarm_answer", swarm_answer, Choices{"place", "best"},
           "What a search answers: the mean of the likeliest place's searchers, or the best pose "
           "that any of them found.");
    option("swarm_match", swarm_match,
           "Align the scan with the map from the best place on; otherwise the swarm's spread tells "
           "how sure a place is.");
    option("swarm_tolerance", swarm_tolerance, kNotNegative, "m, 1",
           "Cost that is good enough to end a search.");
    option("swarm_max_iterations", swarm_max_iterations, Range{1, 1000000}, "",
           "Iterations of a search at the most.");
    option("swarm_patience", swarm_patience, Range{0, 1000000}, "",
           "Iterations without progress that end a search; 0: any number.");
    option("swarm_budget", swarm_budget, Range{1e-3, 1e4}, "",
           "Work of a search at the most, the first look of each searcher among it: 1 is a million "
           "ranges looked up, about 2 ms; a ray that is cast counts as 150 of them, the move of a "
           "searcher as 25, a leader that it looks at as 1. Searchers that could not fly 10 "
           "iterations each are left out.");
    option(
        "wrap_map", wrap_map,
        "While the swarm looks for the robot all over the map, a searcher that leaves at one end "
        "of the map comes back at the other; odometry, rays and matches end where the map does.");
  }
};

/// What a swarm found.
struct SwarmFix {
  Estimate estimate{};           // of the bats
  double cost{0.0};              // of the match, else of its pose: of ranges, by ray casting
  std::optional<Match> match{};  // of the scan from that pose on, if it tells something
  bool has_odometry{false};      // weighed in by the search
  int iterations{0};
  Particles bats{};     // weighed by their cost
  Particles leaders{};  // of the bats
};

/// Lets a swarm loose on a scan.
class SwarmFixer {
 public:
  SwarmFixer(const SwarmFixOptions& options, const RangeObjectiveOptions& objective,
             const std::optional<LeaderOptions>& leaders, double max_range,
             std::shared_ptr<const OccupancyGrid> map,
             std::shared_ptr<const DistanceField> distance_field, std::shared_ptr<Places> places,
             RayCast cast);

  /// The best poses for a scan all over the map, from these on.
  SwarmFix fix(const Particles& start, const SwarmMove& move, const Observations& observations,
               Rng& rng);

  /// The best poses for a scan where odometry says the robot is: far off, a place has to fit
  /// better.
  SwarmFix fixNear(const Gaussian2& odometry, const Particles& start, const SwarmMove& move,
                   const Observations& observations, Rng& rng);

  /// So many of the searchers as the budget lets search where the option says ranges come from.
  int affordable(int searchers) const;

  /// The cost of a pose, by ray casting, as the constructor was told.
  double costOf(const Pose2& T_map_base, const Observations& observations) const;

  /// The largest cost there is.
  double worst() const;

 private:
  Estimate answerOf(const Swarm& swarm, const Particles& bats) const;
  std::unique_ptr<RangeObjective> rangesOf(const Observations& observations);
  SwarmPrice priceOf(bool is_cast) const;
  SwarmFix searchIn(const SearchSpace& space, const Eigen::ArrayXXd& start, const SwarmMove& move,
                    const Objective& objective, StopRule rule, Rng& rng) const;
  StopRule stopRule() const;

  SwarmFixOptions options_;
  RangeObjectiveOptions objective_;
  std::optional<LeaderOptions> leaders_;  // of swarms that have such
  double max_range_;
  std::shared_ptr<const OccupancyGrid> map_;
  std::shared_ptr<const DistanceField> distance_field_;
  std::shared_ptr<Places> places_;
  std::shared_ptr<const EnergyGrid> grid_;
  std::shared_ptr<const RangeRows> rows_;  // of grid_
  RayCast cast_;
  SearchSpace whole_;
};

}  // namespace adaptive_localization
