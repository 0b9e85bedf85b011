// SPDX-License-Identifier: BSD-3-Clause
// Where a swarm looks that does not know where it is, or does not believe it any more.
#include <algorithm>

#include "particle/gaussian_cloud.hpp"
#include "swarm_filter.hpp"

namespace adaptive_localization {
namespace {

constexpr int kScansPerSpread = 3;  // while nothing is found elsewhere
constexpr int kScansPerLaterSpread = 10;

}  // namespace

void SwarmFilter::drawElsewhere() {
  Particles all(options_.swarm_size);
  for (Eigen::Index i = 0; i < all.size(); ++i) all.setPose(i, parts_.elsewhere->draw(rng_));
  bats_ = std::move(all);
}

/// What the tracker knew is of another place.
SwarmFix SwarmFilter::lookElsewhere(const Observations& observations) {
  parts_.elsewhere->condition(observations);
  drawElsewhere();
  SwarmFix fix = parts_.fixer->fix(bats_, *parts_.move, observations, rng_);
  trackHeaviest(fix.estimate);
  align(observations, fix);
  return fix;
}

void SwarmFilter::fixAnywhere(const Observations& observations) {
  const SwarmFix fix = lookElsewhere(observations);
  take(fix, false);
  anywhere_ = fix.cost > options_.swarm_explained;
}

/// At the first scan that the swarm's place does not explain, and at some of those that follow.
bool SwarmFilter::isSpreadDue(double cost) {
  unexplained_ = cost > options_.swarm_explained ? unexplained_ + 1 : 0;
  const int since = unexplained_ - 1;
  return since >= 0 &&
         since % (since < kScansPerLaterSpread ? kScansPerSpread : kScansPerLaterSpread) == 0;
}

void SwarmFilter::spread(const Observations& observations) {
  take(lookElsewhere(observations), false);
}

}  // namespace adaptive_localization
