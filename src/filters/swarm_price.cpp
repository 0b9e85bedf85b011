// SPDX-License-Identifier: BSD-3-Clause
#include "swarm_price.hpp"

#include <algorithm>

#include "swarm/leaders.hpp"

namespace adaptive_localization {
namespace {

constexpr double kRay = 150.0;  // a ray that is cast
constexpr double kMove = 25.0;  // a searcher's way to the next place
constexpr double kLeader = 1.0;

}  // namespace

SwarmPrice::SwarmPrice(int beams, bool is_cast, const std::optional<LeaderOptions>& leaders)
    : beams_(is_cast ? kRay * beams : beams), leaders_(leaders) {}

double SwarmPrice::ofOne(Eigen::Index searchers) const {
  if (!leaders_) return beams_ + kMove;
  const auto leaders =
      numberOfLeaders(searchers, leaders_->leaders_per_bats, leaders_->min_leaders);
  return beams_ + kMove + kLeader * static_cast<double>(leaders);
}

Eigen::Index SwarmPrice::affordable(Eigen::Index searchers, double budget) const {
  Eigen::Index enough = std::min<Eigen::Index>(2, searchers), too_many = searchers + 1;
  while (enough + 1 < too_many) {
    const Eigen::Index middle = enough + (too_many - enough) / 2;
    const bool is_paid = kRounds * static_cast<double>(middle) * ofOne(middle) <= budget;
    (is_paid ? enough : too_many) = middle;
  }
  return enough;
}

}  // namespace adaptive_localization
