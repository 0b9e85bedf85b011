// SPDX-License-Identifier: BSD-3-Clause
#include "swarm_filter.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "adaptive_localization/particle/gaussian_cloud.hpp"
#include "adaptive_localization/particle/resampling.hpp"
#include "adaptive_localization/particle/summary.hpp"
#include "adaptive_localization/ser/global_search.hpp"

namespace adaptive_localization {
namespace {

constexpr double kCloudXy = 0.06;  // m, rad: a cloud is at least so wide
constexpr double kCloudTheta = 0.04;
constexpr double kShareHere = 0.2;     // of the bats stay when others look elsewhere
constexpr double kSecondPlace = 0.05;  // mass of a mode that counts
constexpr float kNarrow = 0.25F;       // m
constexpr double kCovered = 0.7;       // share of beams
constexpr int kScansPerSpread = 3;     // while nothing is found elsewhere
constexpr double kHopeless = 0.6;      // share of the worst cost that tells nothing

/// Symmetric, finite, without negative eigenvalues.
Eigen::Matrix3d mended(const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d root = squareRoot(covariance);
  return root * root.transpose();
}

Estimate oneMode(const Pose2& T_map_base, const Eigen::Matrix3d& covariance) {
  return {T_map_base, covariance, {{T_map_base, covariance, 1.0}}};
}

/// Whether somebody holds a hand before the laser: no place is so narrow.
bool isCovered(const Scan& scan) {
  const auto beams = scan.range.size() + scan.no_return_bearing.size();
  return static_cast<double>((scan.range < kNarrow).count()) >
         kCovered * static_cast<double>(beams);
}

bool hasSecondPlace(const Estimate& estimate) {
  return estimate.modes.size() > 1 && estimate.modes[1].mass > kSecondPlace;
}

}  // namespace

void SwarmFilter::reset(const Prior& prior) {
  unexplained_ = 0;
  candidate_.reset();
  anywhere_ = is_undecided_ = false;
  is_fix_asked_ = true;
  leaders_ = {};
  const auto* cloud = std::get_if<Particles>(&prior);
  if (cloud && cloud->size() > 0) {
    bats_ = *cloud;
    bats_.log_weight = normalisedWeights(cloud->log_weight).log();
    estimate_ = summarize(bats_, bats_.log_weight.exp());
    is_undecided_ = hasSecondPlace(estimate_);
  } else if (const auto* gaussian = std::get_if<Gaussian2>(&prior)) {
    estimate_ = oneMode(gaussian->mean, mended(gaussian->covariance));
    bats_ = drawCloud({gaussian->mean, estimate_.covariance}, options_.swarm_size, rng_);
  } else {
    anywhere_ = true;
    parts_.elsewhere->condition(Observations{});  // forgets what was seen before
    drawElsewhere(0.0);
    estimate_ = summarize(bats_, normalisedWeights(bats_.log_weight));
  }
}

/// A share of the bats stays about where the robot should be.
void SwarmFilter::drawElsewhere(double share_here) {
  const auto here = static_cast<Eigen::Index>(share_here * options_.swarm_size);
  Particles all(options_.swarm_size);
  const Particles before = bats_;
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    all.setPose(i, i < here ? before.pose(i % before.size()) : parts_.elsewhere->draw(rng_));
  }
  bats_ = std::move(all);
}

Estimate SwarmFilter::update(const Pose2& motion, const Observations& observations) {
  ride(motion);
  if (observations.scan.hits() == 0 || isCovered(observations.scan)) return estimate_;
  if (anywhere_) {
    fixAnywhere(observations);
  } else if (isFixDue(observations)) {
    fixHere(observations);
  }
  return estimate_;
}

/// Moves pose, bats and modes, and adds the noise of odometry.
void SwarmFilter::ride(const Pose2& motion) {
  if (!isPlausible(motion)) return;
  const Eigen::Matrix3d noise = parts_.motion->covariance(motion);
  const auto grown = [&](const Pose2& pose, const Eigen::Matrix3d& covariance) {
    const double c = std::cos(pose.theta), s = std::sin(pose.theta);
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity(), turn = Eigen::Matrix3d::Identity();
    F(0, 2) = -s * motion.x - c * motion.y;
    F(1, 2) = c * motion.x - s * motion.y;
    turn.topLeftCorner<2, 2>() << c, -s, s, c;
    const Eigen::Matrix3d sum = F * covariance * F.transpose() + turn * noise * turn.transpose();
    return Eigen::Matrix3d(0.5 * (sum + sum.transpose()));
  };
  if (candidate_) candidate_ = *candidate_ * motion;
  estimate_.covariance = grown(estimate_.T_map_base, estimate_.covariance);
  estimate_.T_map_base = parts_.fixer->inMap(estimate_.T_map_base * motion);
  for (Mode& mode : estimate_.modes) {
    mode.covariance = grown(mode.T_map_base, mode.covariance);
    mode.T_map_base = parts_.fixer->inMap(mode.T_map_base * motion);
  }
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

/// The swarm looks near where odometry says the robot is, or goes on in the places it is in.
void SwarmFilter::fixHere(const Observations& observations) {
  if (is_undecided_) {
    const Eigen::ArrayXd weights = normalisedWeights(bats_.log_weight);
    bats_ = select(bats_, systematicIndices(weights, options_.swarm_size, rng_));
    for (Eigen::Index i = 0; i < bats_.size(); ++i) {
      bats_.setPose(i, bats_.pose(i) * Pose2{rng_.normal(0.0, kCloudXy), rng_.normal(0.0, kCloudXy),
                                             rng_.normal(0.0, kCloudTheta)});
    }
  } else {
    Eigen::Matrix3d covariance = estimate_.covariance;
    covariance.diagonal() +=
        Eigen::Vector3d(kCloudXy * kCloudXy, kCloudXy * kCloudXy, kCloudTheta * kCloudTheta);
    bats_ = drawCloud({estimate_.T_map_base, covariance}, options_.swarm_size, rng_);
  }
  const SwarmFix fix = parts_.fixer->fix(bats_, is_undecided_, *parts_.move, observations, rng_);
  if (fix.cost <= options_.swarm_explained) {
    unexplained_ = 0;
    candidate_.reset();
    take(fix, options_.swarm_fuse && !is_fix_asked_ && !is_undecided_);
    return;
  }
  ++unexplained_;
  const int since = unexplained_ - options_.swarm_confirm_scans;
  if (since >= 0 && (candidate_ || since % kScansPerSpread == 0)) {
    lookElsewhere(observations, fix);
  } else if (fix.cost < kHopeless * parts_.fixer->worst()) {
    take(fix, options_.swarm_fuse && !is_fix_asked_ && !is_undecided_);
  }
}

void SwarmFilter::fixAnywhere(const Observations& observations) {
  parts_.elsewhere->condition(observations);
  drawElsewhere(0.0);
  const SwarmFix fix = parts_.fixer->fix(bats_, true, *parts_.move, observations, rng_);
  take(fix, false);
  anywhere_ = fix.cost > options_.swarm_explained;
}

void SwarmFilter::lookElsewhere(const Observations& observations, const SwarmFix& here) {
  parts_.elsewhere->condition(observations);
  bats_ = here.bats;
  drawElsewhere(kShareHere);
  const SwarmFix fix = parts_.fixer->fix(bats_, true, *parts_.move, observations, rng_);
  const bool is_better =
      fix.cost <= options_.swarm_explained && fix.cost * options_.swarm_ratio < here.cost;
  const bool is_certain = options_.swarm_confirm_scans == 1 ||
                          (candidate_ && areSamePlace(*candidate_, fix.estimate.T_map_base));
  candidate_.reset();
  if (options_.swarm_ratio == 0.0 || (is_better && is_certain)) {
    take(fix, false);
    if (is_better) unexplained_ = 0;
    return;
  }
  if (is_better) candidate_ = fix.estimate.T_map_base;
  bats_ = here.bats;
  if (here.cost < kHopeless * parts_.fixer->worst()) take(here, options_.swarm_fuse);
}

/// A fix is an observation of the pose: x = x + K (z - x), K = P (P + R)^-1, P = (I - K) P.
void SwarmFilter::take(const SwarmFix& fix, bool is_fused) {
  bats_ = fix.bats;
  leaders_ = fix.leaders;
  is_fix_asked_ = false;
  is_undecided_ = hasSecondPlace(fix.estimate);
  if (!is_fused || is_undecided_) {
    estimate_ = fix.estimate;
    return;
  }
  const Eigen::Matrix3d& P = estimate_.covariance;
  const Eigen::Matrix3d S = P + fix.estimate.covariance;
  const Eigen::Matrix3d K = S.ldlt().solve(P).transpose();
  const Pose2& odometry = estimate_.T_map_base;
  const Pose2& found = fix.estimate.T_map_base;
  const Eigen::Vector3d step = K * Eigen::Vector3d(found.x - odometry.x, found.y - odometry.y,
                                                   wrapAngle(found.theta - odometry.theta));
  const Pose2 pose{odometry.x + step.x(), odometry.y + step.y(),
                   wrapAngle(odometry.theta + step.z())};
  if (!isFinite(pose)) return;
  estimate_ = oneMode(pose, mended(P - K * P));
}

}  // namespace adaptive_localization
