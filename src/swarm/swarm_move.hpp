// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "adaptive_localization/core/options.hpp"
#include "swarm/swarm.hpp"

namespace adaptive_localization {

/// How a swarm moves on by one iteration.
class SwarmMove {
 public:
  virtual ~SwarmMove() = default;
  virtual void step(Swarm& swarm, const Objective& objective, Rng& rng) const = 0;
};

/// Particle swarm with constriction (Clerc and Kennedy 2002):
///
///     v = w v + c1 U1 (own best - x) + c2 U2 (best - x),  w = 0.7298, c1 = c2 = 1.4962
///
/// with |v| at most a fifth of the space in each dimension.
class ParticleSwarmMove : public SwarmMove {
 public:
  void step(Swarm& swarm, const Objective& objective, Rng& rng) const override;
};

/// The defaults are the improved form; see printedBats() for what is printed.
struct BatOptions {
  double bat_frequency{2.0};
  double bat_inertia{0.7};
  bool bat_repulsive{false};
  double bat_walk_share{0.3};
  bool bat_walk_adapts{true};
  double bat_walk_size{0.1};
  double bat_leap_share{0.3};
  bool bat_greedy{true};
  double bat_pulse_rate{0.5};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("bat_frequency", bat_frequency, Range{0, 1e3}, "",
           "Largest frequency: the velocity towards the leader, in distances to it per iteration.");
    option("bat_inertia", bat_inertia, Range{0, 1}, "",
           "Share of its velocity that a bat keeps per iteration.");
    option("bat_repulsive", bat_repulsive,
           "Bats move away from the best one, as printed; a misprint.");
    option("bat_walk_share", bat_walk_share, Range{-1, 1}, "",
           "Share of moves that are local walks; negative: by the pulse rate of each bat, as "
           "printed.");
    option("bat_walk_adapts", bat_walk_adapts,
           "Local walks are as wide as the leader's colony, instead of bat_walk_size.");
    option("bat_walk_size", bat_walk_size, kDeviation, "m, rad",
           "Standard deviation of a local walk in each coordinate.");
    option("bat_leap_share", bat_leap_share, kProbability, "",
           "Share of local walks that change one coordinate only, by a tenth of the space, to "
           "leave local minima.");
    option("bat_greedy", bat_greedy, "A bat takes every better place, whatever its loudness.");
    option("bat_pulse_rate", bat_pulse_rate, kProbability, "",
           "Final pulse rate of a bat (negative bat_walk_share).");
  }
};

struct LeaderOptions {
  int leaders_per_bats{50};
  int min_leaders{3};
  std::string walk_center{"nearest_leader"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("leaders_per_bats", leaders_per_bats, Range{1, 1000000}, "",
           "Number of bats per leader.");
    option("min_leaders", min_leaders, Range{1, 1000000}, "", "Fewest leaders.");
    option("walk_center", walk_center, Choices{"nearest_leader", "global_best"},
           "Centre of local walks: the nearest leader, or the best place of all.");
  }
};

/// Bat algorithm (Yang 2010) and leader-based bat algorithm:
///
///     f = f_max U1;  v = w v + (leader - x) f;  x' = x + v
///     or, as a local walk,  x' = centre + size eps,  eps ~ N(0, 1)
///     x = x' if F(x') <= F(x) and U2 < A;  then r = r0 (1 - exp(-growth t)), A = decay A
///
/// The leader is the best place of all so far, or, with leaders, the nearest in x and y of the best
/// bats of this iteration: its Voronoi cell is a colony. All bats of an iteration see the same
/// leaders.
class BatMove : public SwarmMove {
 public:
  /// The bat algorithm.
  explicit BatMove(const BatOptions& options) : options_(options) {}

  /// With leaders.
  BatMove(const BatOptions& options, const LeaderOptions& leaders)
      : options_(options), leaders_(leaders), has_leaders_(true) {}

  void step(Swarm& swarm, const Objective& objective, Rng& rng) const override;

 private:
  BatOptions options_;
  LeaderOptions leaders_;
  bool has_leaders_{false};
};

/// As printed in the source, but for the sign that is a misprint, and with one leader per 300.
BatOptions printedBats();
LeaderOptions printedLeaders();

}  // namespace adaptive_localization
