// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "swarm/leaders.hpp"
#include "swarm/swarm_move.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLeapSize = 0.1;       // standard deviation of a leap, as a share of the space
constexpr double kLoudnessDecay = 0.9;  // factor on the loudness each time a better place is taken
constexpr double kPulseGrowth = 0.9;    // of the pulse rate, per iteration

/// What an iteration's bats look up to: places, and which of them each bat follows.
struct Colonies {
  Eigen::ArrayXXd centre;            // one place in each row
  std::vector<std::size_t> follows;  // [bat]: row
  Eigen::ArrayXXd width;             // [row]: mean distance of its bats in each dimension
};

Colonies coloniesOf(const Swarm& swarm, const LeaderOptions* leaders) {
  Colonies colonies;
  if (!leaders) {
    colonies.centre = swarm.best.transpose();
    colonies.follows.assign(static_cast<std::size_t>(swarm.size()), 0);
  } else {
    const auto best = bestBats(
        swarm, numberOfLeaders(swarm.size(), leaders->leaders_per_bats, leaders->min_leaders));
    colonies.follows = nearestLeaders(swarm, best);
    colonies.centre.resize(static_cast<Eigen::Index>(best.size()), swarm.space.dimensions());
    for (std::size_t j = 0; j < best.size(); ++j) {
      colonies.centre.row(static_cast<Eigen::Index>(j)) = swarm.position.row(best[j]);
    }
  }
  return colonies;
}

/// Coordinates that are lengths share one width, a heading has its own.
void measure(const Swarm& swarm, Colonies& colonies) {
  const SearchSpace& space = swarm.space;
  colonies.width.setZero(colonies.centre.rows(), space.dimensions());
  Eigen::ArrayXd count = Eigen::ArrayXd::Zero(colonies.centre.rows());
  const Eigen::Index lengths = space.dimensions() - (space.has_heading ? 1 : 0);
  for (Eigen::Index i = 0; i < swarm.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(colonies.follows[static_cast<std::size_t>(i)]);
    double squares = 0.0;
    for (Eigen::Index k = 0; k < lengths; ++k) {
      const double d = space.way(k, swarm.position(i, k), colonies.centre(j, k));
      squares += d * d;
    }
    colonies.width.row(j).head(lengths) += std::sqrt(squares);
    if (space.has_heading) {
      colonies.width(j, lengths) +=
          std::abs(space.way(lengths, swarm.position(i, lengths), colonies.centre(j, lengths)));
    }
    count[j] += 1.0;
  }
  colonies.width.colwise() /= count.max(1.0);
}

/// Where a bat tries to go, coordinate by coordinate.
class Flight {
 public:
  Flight(const BatOptions& options, bool walks_from_best, const Colonies& colonies, Swarm& swarm)
      : options_(options),
        walks_from_best_(walks_from_best),
        colonies_(colonies),
        swarm_(swarm),
        space_(swarm.space) {}

  void tryFrom(Eigen::Index i, Eigen::ArrayXXd& tried, Rng& rng) {
    const auto leader = static_cast<Eigen::Index>(colonies_.follows[static_cast<std::size_t>(i)]);
    fly(i, leader, tried, rng);
    const bool walks = options_.bat_walk_share < 0.0 ? rng.uniform() > swarm_.rate[i]
                                                     : rng.uniform() < options_.bat_walk_share;
    if (!walks) return;
    if (rng.uniform() < options_.bat_leap_share) return leap(i, leader, tried, rng);
    walk(i, leader, tried, rng);
  }

 private:
  void fly(Eigen::Index i, Eigen::Index leader, Eigen::ArrayXXd& tried, Rng& rng) {
    const double sign = options_.bat_repulsive ? -1.0 : 1.0;
    const double frequency = sign * options_.bat_frequency * rng.uniform();
    for (Eigen::Index k = 0; k < space_.dimensions(); ++k) {
      const double x = swarm_.position(i, k);
      double& v = swarm_.velocity(i, k);
      v = options_.bat_inertia * v + space_.way(k, x, colonies_.centre(leader, k)) * frequency;
      if (!(std::abs(v) < kFastest * space_.width(k))) v = 0.0;  // fled to infinity
      tried(i, k) = space_.inside(k, x + v);
    }
  }

  void walk(Eigen::Index i, Eigen::Index leader, Eigen::ArrayXXd& tried, Rng& rng) {
    for (Eigen::Index k = 0; k < space_.dimensions(); ++k) {
      const double size =
          options_.bat_walk_adapts ? 0.5 * colonies_.width(leader, k) : options_.bat_walk_size;
      tried(i, k) = space_.inside(k, centre(leader, k) + size * rng.normal());
    }
  }

  void leap(Eigen::Index i, Eigen::Index leader, Eigen::ArrayXXd& tried, Rng& rng) {
    const auto axis =
        static_cast<Eigen::Index>(rng.below(static_cast<std::size_t>(space_.dimensions())));
    for (Eigen::Index k = 0; k < space_.dimensions(); ++k) tried(i, k) = centre(leader, k);
    const double size = kLeapSize * space_.width(axis);
    tried(i, axis) = space_.inside(axis, tried(i, axis) + size * rng.normal());
  }

  double centre(Eigen::Index leader, Eigen::Index k) const {
    return walks_from_best_ ? swarm_.best[k] : colonies_.centre(leader, k);
  }

  static constexpr double kFastest = 1e6;  // widths of the space in one iteration

  const BatOptions& options_;
  bool walks_from_best_;
  const Colonies& colonies_;
  Swarm& swarm_;
  const SearchSpace& space_;
};

}  // namespace

void BatMove::step(Swarm& swarm, const Objective& objective, Rng& rng) const {
  Colonies colonies = coloniesOf(swarm, has_leaders_ ? &leaders_ : nullptr);
  if (options_.bat_walk_adapts) measure(swarm, colonies);
  const bool walks_from_best = has_leaders_ && leaders_.walk_center == "global_best";
  Eigen::ArrayXXd tried(swarm.size(), swarm.space.dimensions());
  Flight flight(options_, walks_from_best, colonies, swarm);
  for (Eigen::Index i = 0; i < swarm.size(); ++i) flight.tryFrom(i, tried, rng);
  Eigen::ArrayXd costs(swarm.size());
  objective.evaluate(tried, costs);
  const double rate = options_.bat_pulse_rate * (1.0 - std::exp(-kPulseGrowth * swarm.iteration));
  for (Eigen::Index i = 0; i < swarm.size(); ++i) {
    const bool is_loud = options_.bat_greedy || rng.uniform() < swarm.loudness[i];
    if (!(costs[i] <= swarm.cost[i]) || !is_loud) continue;
    swarm.position.row(i) = tried.row(i);
    swarm.cost[i] = costs[i];
    swarm.rate[i] = rate;
    swarm.loudness[i] *= kLoudnessDecay;
  }
  swarm.note(tried, costs);
  ++swarm.iteration;
}

BatOptions printedBats() {
  BatOptions options;
  options.bat_frequency = 1.0;
  options.bat_inertia = 1.0;
  options.bat_walk_share = -1.0;
  options.bat_walk_adapts = false;
  options.bat_leap_share = 0.0;
  options.bat_greedy = false;
  return options;
}

LeaderOptions printedLeaders() {
  return {300, 1, "global_best"};
}

}  // namespace adaptive_localization
