// SPDX-License-Identifier: BSD-3-Clause
#include "ekf_icp.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "adaptive_localization/particle/gaussian_cloud.hpp"
#include "adaptive_localization/particle/resampling.hpp"
#include "adaptive_localization/particle/summary.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kPlaces = 5;      // that are looked at
constexpr double kUnusual = 0.5;        // inlier ratio, of the usual one
constexpr double kJump = 0.5;           // m, rad: odometry that may have jumped
constexpr double kBetter = 1.2;         // inlier ratio of a place against that of one at hand
constexpr double kNewPlaceStd = 0.05;   // m, of a place just found, beyond what the match says
constexpr double kNewPlaceTurn = 0.02;  // rad

/// A search is dear: after 1, 2, 4, 8, ... scans that nothing explains.
bool isPowerOfTwo(int count) {
  return count > 0 && (count & (count - 1)) == 0;
}

}  // namespace

void EkfIcp::reset(const Prior& prior) {
  anywhere_ = false;
  rejected_ = 0;
  candidate_.reset();
  match_.reset();
  const auto* cloud = std::get_if<Particles>(&prior);
  if (cloud && cloud->size() > 0) {
    const Estimate all = summarize(*cloud, normalisedWeights(cloud->log_weight));
    kalman_.reset({all.T_map_base, all.covariance});
  } else if (const auto* gaussian = std::get_if<Gaussian2>(&prior)) {
    kalman_.reset(*gaussian);
  } else {
    anywhere_ = true;
    cloud_ = Particles(10 * options_.ekf_cloud);
    for (Eigen::Index i = 0; i < cloud_.size(); ++i) cloud_.setPose(i, parts_.anywhere->draw(rng_));
    const Estimate all = summarize(cloud_, normalisedWeights(cloud_.log_weight));
    kalman_.reset({all.T_map_base, all.covariance});
    return;
  }
  cloud_ = drawCloud(kalman_.belief(), options_.ekf_cloud, rng_);
}

Estimate EkfIcp::estimate() const {
  return {kalman_.mean(), kalman_.covariance(), {{kalman_.mean(), kalman_.covariance(), 1.0}}};
}

Estimate EkfIcp::update(const Pose2& motion, const Observations& observations) {
  const Pose2 before = kalman_.mean();
  if (isPlausible(motion)) {
    kalman_.predict(motion, parts_.motion->covariance(motion));
    if (candidate_) candidate_ = *candidate_ * motion;
  }
  match_ = matchAt(kalman_.mean(), observations.scan);
  if (distance({}, motion) > kJump || std::abs(motion.theta) > kJump) {
    undoJump(before, observations.scan);
  }
  if (anywhere_ && match_->isGood()) match_->fault = MatchFault::kNoGuess;
  const bool is_corrected = match_->isGood() && correct();
  if (is_corrected && isUsual(match_->inlier_ratio)) {
    rejected_ = 0;
    candidate_.reset();
  } else if (match_->fault != MatchFault::kFewHits) {
    ++rejected_;
    lookAround(observations);
  }
  if (!anywhere_) cloud_ = drawCloud(kalman_.belief(), options_.ekf_cloud, rng_);
  return estimate();
}

Match EkfIcp::matchAt(const Pose2& T_map_base, const Scan& scan) const {
  const Eigen::Matrix3d prior = kalman_.covariance().inverse();
  return parts_.match(T_map_base, scan, prior.allFinite() ? prior : Eigen::Matrix3d::Zero());
}

/// Odometry can jump by a metre while the robot stands: the scan tells.
void EkfIcp::undoJump(const Pose2& T_map_base_before, const Scan& scan) {
  const Match stayed = matchAt(T_map_base_before, scan);
  if (!stayed.isGood() || stayed.inlier_ratio < kBetter * match_->inlier_ratio) return;
  kalman_.reset({T_map_base_before, kalman_.covariance()});
  match_ = stayed;
}

/// A wrong place can fit in part: more than usual that does not fit is a reason to look around.
/// What is usual rises fast and falls slowly.
bool EkfIcp::isUsual(double inlier_ratio) {
  usual_ += (inlier_ratio > usual_ ? 0.2 : 0.02) * (inlier_ratio - usual_);
  return inlier_ratio > kUnusual * usual_;
}

/// By the match, which is good; says what is wrong with it if not.
bool EkfIcp::correct() {
  const PoseObservation seen = observationOf(kalman_.mean(), *match_);
  const bool is_near = kalman_.distanceOf(seen) < options_.ekf_gate;
  if (is_near && kalman_.correct(seen)) return true;
  match_->fault = MatchFault::kJump;
  return false;
}

/// From an unknown start the first place that fits will do; otherwise it must fit the next scan
/// too.
void EkfIcp::lookAround(const Observations& observations) {
  const int since = rejected_ - options_.ekf_rejected_scans + 1;
  if (!anywhere_ && !(since > 0 && (candidate_ || isPowerOfTwo(since)))) return;
  const bool was_found = candidate_.has_value();
  const auto found = matchElsewhere(observations);
  candidate_.reset();
  if (!found) return;
  if (!anywhere_ && !was_found) {
    candidate_ = found->T_map_base;
    return;
  }
  Gaussian2 place{found->T_map_base,
                  Eigen::Vector3d(kNewPlaceStd * kNewPlaceStd, kNewPlaceStd * kNewPlaceStd,
                                  kNewPlaceTurn * kNewPlaceTurn)
                      .asDiagonal()};
  kalman_.reset(place);
  kalman_.correct(observationOf(place.mean, *found));
  match_ = found;
  anywhere_ = false;
  rejected_ = 0;
}

/// The place that most of the scan fits, clearly more than where the robot is believed to be; one
/// found before, and one that only odometry gainsays, as long as no other is clearly better.
std::optional<Match> EkfIcp::matchElsewhere(const Observations& observations) {
  std::optional<Match> best;
  double least = 0.0;  // inlier ratio that counts
  const auto tryAt = [&](const Pose2& guess) {
    const Match match = parts_.match(guess, observations.scan, Eigen::Matrix3d::Zero());
    if (!match.isGood() || match.inlier_ratio <= least) return;
    best = match;
    least = match.inlier_ratio;
  };
  if (!anywhere_ && match_->isGood()) least = kBetter * match_->inlier_ratio;
  if (candidate_) tryAt(*candidate_);
  if (best) return best;
  if (!anywhere_ && match_->fault == MatchFault::kJump) {
    tryAt(match_->T_map_base);
    least *= kBetter;
  }
  std::size_t tried = 0;
  for (const Place& place : parts_.places->search(observations)) {
    if (tried++ < kPlaces) tryAt(place.T_map_base);
  }
  return best;
}

}  // namespace adaptive_localization
