// SPDX-License-Identifier: BSD-3-Clause
#include "swarm_filter.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "adaptive_localization/particle/resampling.hpp"
#include "adaptive_localization/particle/summary.hpp"
#include "particle/gaussian_cloud.hpp"
#include "ser/global_search.hpp"

namespace adaptive_localization {
namespace {

constexpr double kCloudXy = 0.06, kCloudTheta = 0.04;  // m, rad: a cloud is at least so wide
constexpr double kSecondPlace = 0.05;                  // mass of a mode that counts
constexpr double kUnexpectedRatio = 2.5;  // of costs, at which a fix may contradict odometry,
constexpr int kStrangeScans = 2;          // so many times in a row
constexpr double kHopeless = 0.8;         // share of the worst cost that tells nothing, unmatched
constexpr double kUnsure = 9.0;       // a place found anew is so much less sure than its bats agree
constexpr double kAstray = 1.5;       // a match whose cost is so many times larger,
constexpr double kAstrayMore = 0.03;  // m, 1: and so much more, went astray

Estimate oneMode(const Pose2& T_map_base, const Eigen::Matrix3d& covariance) {
  return {T_map_base, covariance, {{T_map_base, covariance, 1.0}}};
}

/// Where the robot is if odometry tells nothing of it.
Gaussian2 startOf(const SwarmFix& fix) {
  const Mode& heaviest = fix.estimate.modes.front();
  if (!fix.match) return {heaviest.T_map_base, heaviest.covariance};
  return {fix.match->T_map_base, kUnsure * heaviest.covariance};
}

bool hasSecondPlace(const Estimate& estimate) {
  return estimate.modes.size() > 1 && estimate.modes[1].mass > kSecondPlace;
}

}  // namespace

void SwarmFilter::reset(const Prior& prior) {
  unexplained_ = strange_ = 0;
  anywhere_ = is_undecided_ = false;
  is_fix_asked_ = true;
  leaders_ = {};
  pending_.finish();
  const auto* cloud = std::get_if<Particles>(&prior);
  if (cloud && cloud->size() > 0) {
    bats_ = *cloud;
    bats_.log_weight = normalisedWeights(cloud->log_weight).log();
    estimate_ = summarize(bats_, bats_.log_weight.exp());
    is_undecided_ = hasSecondPlace(estimate_);
  } else if (const auto* gaussian = std::get_if<Gaussian2>(&prior)) {
    tracker_.reset(*gaussian);
    estimate_ = oneMode(tracker_.mean(), tracker_.covariance());
    bats_ = drawCloud(tracker_.belief(), options_.swarm_size, rng_);
  } else {
    anywhere_ = true;
    parts_.elsewhere->condition(Observations{});  // forgets what was seen before
    drawElsewhere();
    estimate_ = summarize(bats_, normalisedWeights(bats_.log_weight));
  }
  trackHeaviest(estimate_);
}

void SwarmFilter::trackHeaviest(const Estimate& estimate) {
  tracker_.reset({estimate.modes.front().T_map_base, estimate.modes.front().covariance});
}

/// What odometry leaves open, and so much more.
Eigen::Matrix3d SwarmFilter::cloudCovariance(double xy, double theta) const {
  Eigen::Matrix3d covariance = estimate_.covariance;
  covariance.diagonal() += Eigen::Vector3d(xy * xy, xy * xy, theta * theta);
  return covariance;
}

Estimate SwarmFilter::update(const Pose2& motion, const Observations& observations) {
  ride(pending_.rest(motion), observations);
  pending_.move(motion);
  if (observations.scan.hits() > 0) fix(observations);
  pending_.finish();
  return estimate_;
}

void SwarmFilter::fix(const Observations& observations) {
  if (anywhere_) {
    fixAnywhere(observations);
  } else if (isFixDue(observations)) {
    fixHere(observations);
  }
}

/// Moves pose and bats, adds the noise of odometry, and listens to other senses than the laser. The
/// heaviest mode comes last: the tracker goes on from it.
void SwarmFilter::ride(const Pose2& motion, const Observations& observations) {
  if (!isPlausible(motion)) return;
  const Eigen::Matrix3d noise = parts_.motion->covariance(motion);
  Estimate moved = estimate_;  // as one, since senses may throw
  for (auto mode = moved.modes.rbegin(); mode != moved.modes.rend(); ++mode) {
    tracker_.reset({mode->T_map_base, mode->covariance});
    tracker_.predict(motion, noise);
    tracker_.correctBy(*parts_.senses, observations);
    mode->T_map_base = tracker_.mean();
    mode->covariance = tracker_.covariance();
  }
  moved.T_map_base = moved.modes.front().T_map_base;
  moved.covariance = moved.modes.front().covariance;
  estimate_ = std::move(moved);
  for (Particles* cloud : {&bats_, &leaders_}) {
    for (Eigen::Index i = 0; i < cloud->size(); ++i) cloud->setPose(i, cloud->pose(i) * motion);
  }
}

/// Once the larger axis of the ellipse is too long or the scan does not fit.
bool SwarmFilter::isFixDue(const Observations& observations) const {
  if (is_fix_asked_ || is_undecided_ || unexplained_ > 0) return true;
  const Eigen::Matrix2d position = estimate_.covariance.topLeftCorner<2, 2>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(position, Eigen::EigenvaluesOnly);
  const double deviation = std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
  return deviation >= options_.swarm_fix_deviation ||
         parts_.fixer->costOf(estimate_.T_map_base, observations) > options_.swarm_explained;
}

/// The scan matched from the swarm's place on, unless its cost there says that the match went
/// astray.
void SwarmFilter::align(const Observations& observations, SwarmFix& fix) const {
  if (!parts_.match) return;
  Match match = tracker_.matchAt(fix.estimate.T_map_base, observations.scan);
  if (!match.isGood()) return;
  const double cost = parts_.fixer->costOf(match.T_map_base, observations);
  if (cost > kAstray * fix.cost + kAstrayMore) return;
  fix.cost = cost;
  fix.match = std::move(match);
}

/// Bats near where odometry says the robot is, or in the places that they are in.
SwarmFix SwarmFilter::lookHere(const Observations& observations) {
  if (!is_undecided_) {
    const Gaussian2 odometry{estimate_.T_map_base, estimate_.covariance};
    const Gaussian2 wider{odometry.mean, cloudCovariance(kCloudXy, kCloudTheta)};
    bats_ = drawCloud(wider, options_.swarm_size, rng_);
    return parts_.fixer->fixNear(odometry, bats_, *parts_.move, observations, rng_);
  }
  const Eigen::ArrayXd weights = normalisedWeights(bats_.log_weight);
  bats_ = select(bats_, systematicIndices(weights, options_.swarm_size, rng_));
  for (Eigen::Index i = 0; i < bats_.size(); ++i) {
    const double x = rng_.normal(0.0, kCloudXy), y = rng_.normal(0.0, kCloudXy);
    bats_.setPose(i, bats_.pose(i) * Pose2{x, y, rng_.normal(0.0, kCloudTheta)});
  }
  const SwarmFix fix = parts_.fixer->fix(bats_, *parts_.move, observations, rng_);
  trackHeaviest(fix.estimate);
  return fix;
}

void SwarmFilter::fixHere(const Observations& observations) {
  SwarmFix fix = lookHere(observations);
  align(observations, fix);
  if (options_.swarm_spread && isSpreadDue(fix.cost)) return spread(observations);
  takeIfPlausible(fix, observations);
}

void SwarmFilter::takeIfPlausible(const SwarmFix& fix, const Observations& observations) {
  const bool is_hopeless = !fix.match && fix.cost > kHopeless * parts_.fixer->worst();
  if (is_hopeless || isUnexpected(fix, observations)) return;
  take(fix, options_.swarm_fuse && !is_undecided_);
}

/// What a fix says of the tracker's pose: the match in the directions of which it tells, else the
/// bats as one.
PoseObservation SwarmFilter::observationOf(const SwarmFix& fix) const {
  const Pose2& pose = tracker_.mean();
  if (fix.match) return adaptive_localization::observationOf(pose, *fix.match);
  const Estimate& bats = fix.estimate;
  return adaptive_localization::observationOf(pose, Gaussian2{bats.T_map_base, bats.covariance});
}

/// Whether a fix contradicts odometry though hardly anything speaks for it.
bool SwarmFilter::isUnexpected(const SwarmFix& fix, const Observations& observations) {
  if (!options_.swarm_fuse || is_fix_asked_ || is_undecided_) return false;
  const PoseObservation seen = observationOf(fix);
  if (seen.innovation.size() == 0 || !tracker_.isOutlier(seen)) {
    strange_ = 0;
    return false;
  }
  const double cost_here = parts_.fixer->costOf(estimate_.T_map_base, observations);
  if (fix.cost * kUnexpectedRatio > cost_here) return true;
  return ++strange_ < kStrangeScans;
}

/// A fix that is fused is an observation of the pose; otherwise, or if odometry cannot explain it
/// or was weighed in already, it is where the robot is.
void SwarmFilter::take(const SwarmFix& fix, bool is_fused) {
  bats_ = fix.bats;
  leaders_ = fix.leaders;
  is_undecided_ = hasSecondPlace(fix.estimate);
  const bool is_news = fix.match || !fix.has_odometry;
  const bool goes_on = is_fused && !is_undecided_ && strange_ == 0 && is_news;
  if (!goes_on) tracker_.reset(startOf(fix));
  if (fix.match || goes_on) tracker_.correct(observationOf(fix));
  strange_ = 0;
  is_fix_asked_ = false;
  if (!is_undecided_) {
    estimate_ = oneMode(tracker_.mean(), tracker_.covariance());
    return;
  }
  estimate_ = fix.estimate;
  estimate_.T_map_base = estimate_.modes.front().T_map_base = tracker_.mean();
  estimate_.covariance = estimate_.modes.front().covariance = tracker_.covariance();
}

}  // namespace adaptive_localization
