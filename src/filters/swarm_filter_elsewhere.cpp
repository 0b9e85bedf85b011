// SPDX-License-Identifier: BSD-3-Clause
// Where a swarm looks that does not know where it is, or does not believe it any more.
#include <algorithm>

#include "adaptive_localization/particle/gaussian_cloud.hpp"
#include "swarm_filter.hpp"

namespace adaptive_localization {
namespace {

constexpr double kSlipXy = 0.5, kSlipTheta = 0.3;  // m, rad: and here, when others look elsewhere
constexpr double kShareHere = 0.2;                 // of the bats, then
constexpr std::size_t kCandidates = 5;
constexpr int kScansPerSpread = 3;  // while nothing is found elsewhere
constexpr int kScansPerLaterSpread = 10;

}  // namespace

/// A share of the bats stays about where the robot should be.
void SwarmFilter::drawElsewhere(double share_here) {
  const auto here = static_cast<Eigen::Index>(share_here * options_.swarm_size);
  const Gaussian2 near{estimate_.T_map_base, cloudCovariance(kSlipXy, kSlipTheta)};
  const Particles cloud = drawCloud(near, here, rng_);
  Particles all(options_.swarm_size);
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    all.setPose(i, i < here ? cloud.pose(i) : parts_.elsewhere->draw(rng_));
  }
  bats_ = std::move(all);
}

void SwarmFilter::fixAnywhere(const Observations& observations) {
  parts_.elsewhere->condition(observations);
  drawElsewhere(0.0);
  const SwarmFix fix = parts_.fixer->fix(bats_, *parts_.move, observations, rng_);
  take(fix, false);
  anywhere_ = fix.cost > options_.swarm_explained;
}

/// Where the swarm found a better place in the last scan, that is looked at; else it spreads.
void SwarmFilter::lookElsewhere(const Observations& observations, const SwarmFix& here) {
  const bool is_candidate_right = goesTo(candidates_, observations, here.cost);
  const int since = unexplained_ - options_.swarm_confirm_scans;
  if (is_candidate_right) return;
  candidates_.clear();
  if (since % (since < kScansPerLaterSpread ? kScansPerSpread : kScansPerLaterSpread) == 0) {
    parts_.elsewhere->condition(observations);
    drawElsewhere(kShareHere);
    const SwarmFix fix = parts_.fixer->fix(bats_, *parts_.move, observations, rng_);
    if (options_.swarm_ratio == 0.0) return take(fix, false);
    candidates_ = fix.estimate.modes;
    candidates_.resize(std::min(candidates_.size(), kCandidates));
    if (options_.swarm_confirm_scans == 1 && goesTo(candidates_, observations, here.cost)) return;
  }
  usual_.observe(here.cost);
  takeIfPlausible(here, observations);
}

/// Goes to the place that explains the scan best, if it is much better than here.
bool SwarmFilter::goesTo(const std::vector<Mode>& places, const Observations& observations,
                         double cost_here) {
  SwarmFix best;
  best.cost = std::min(options_.swarm_explained, cost_here / options_.swarm_ratio);
  bool is_found = false;
  for (const Mode& place : places) {
    SwarmFix fix = parts_.fixer->fixAt({place.T_map_base, place.covariance, 1.0}, observations);
    if (fix.cost > best.cost) continue;
    best = std::move(fix);
    is_found = true;
  }
  if (!is_found) return false;
  best.bats = drawCloud({best.place(), best.estimate.covariance}, options_.swarm_size, rng_);
  take(best, false);
  usual_.observe(best.cost);
  unexplained_ = 0;
  candidates_.clear();
  return true;
}

}  // namespace adaptive_localization
