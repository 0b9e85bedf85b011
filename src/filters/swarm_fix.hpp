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
           "Source of expected ranges: table, the energy grid's, once it is made; cast, exact ray "
           "casting in the map; lines, in the walls of line_map. Casting is limited by the laser's "
           "range alone.");
    option("swarm_near", swarm_near, Choices{"hits", "ranges"},
           "Cost that the swarm minimizes near the pose by odometry: hits, the mean distance of "
           "hits from the map's walls; ranges, the one of swarm_error.");
    option("swarm_answer", swarm_answer, Choices{"place", "best"},
           "Answer of a search: place, the mean of the searchers at the likeliest place; best, the "
           "best pose that any of them found.");
    option("swarm_match", swarm_match,
           "Match the scan with the map from the best place on; otherwise the spread of the swarm "
           "is the answer's covariance.");
    option("swarm_tolerance", swarm_tolerance, kNotNegative, "m, 1",
           "Cost at which a search ends.");
    option("swarm_max_iterations", swarm_max_iterations, Range{1, 1000000}, "",
           "Largest number of iterations of a search.");
    option("swarm_patience", swarm_patience, Range{0, 1000000}, "",
           "A search ends after so many iterations without progress; 0: never.");
    option("swarm_budget", swarm_budget, Range{1e-3, 1e4}, "",
           "Work limit of a search in millions of range look-ups, about 2 ms each; the first "
           "evaluation counts. A cast ray counts 150, a move of a searcher 25, a leader that it is "
           "compared with 1. The swarm is reduced so that 10 iterations fit.");
    option("wrap_map", wrap_map,
           "While the swarm searches the whole map, a searcher that leaves at one end comes back "
           "at the other; motion, rays and matches do not.");
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
