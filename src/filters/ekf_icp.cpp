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
constexpr int kScansPerSearch = 3;      // while nothing is found: a search is dear
constexpr double kBetter = 1.2;         // inlier ratio of a place against that of one at hand
constexpr double kNewPlaceStd = 0.05;   // m, of a place just found, beyond what the match says
constexpr double kNewPlaceTurn = 0.02;  // rad

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
  if (isPlausible(motion)) {
    kalman_.predict(motion, parts_.motion->covariance(motion));
    if (candidate_) candidate_ = *candidate_ * motion;
  }
  const Eigen::Matrix3d prior = kalman_.covariance().inverse();
  match_ = parts_.match(kalman_.mean(), observations.scan,
                        prior.allFinite() ? prior : Eigen::Matrix3d::Zero());
  const bool is_blind = match_->fault == MatchFault::kFewHits;
  if (!anywhere_ && correct(*match_)) {
    rejected_ = 0;
    candidate_.reset();
  } else if (!is_blind) {
    ++rejected_;
    lookAround(observations);
  }
  if (!anywhere_) cloud_ = drawCloud(kalman_.belief(), options_.ekf_cloud, rng_);
  return estimate();
}

bool EkfIcp::correct(const Match& match) {
  if (!match.isGood()) return false;
  const PoseObservation seen = observationOf(kalman_.mean(), match);
  if (!(kalman_.distanceOf(seen) < options_.ekf_gate)) {
    match_->fault = MatchFault::kJump;
    return false;
  }
  return kalman_.correct(seen);
}

/// From an unknown start the first place that fits will do; otherwise it must fit the next scan
/// too.
void EkfIcp::lookAround(const Observations& observations) {
  const int since = rejected_ - options_.ekf_rejected_scans;
  const bool is_due = anywhere_ || (since >= 0 && (candidate_ || since % kScansPerSearch == 0));
  if (!is_due) return;
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

/// The place that most of the scan fits; one found before, and one that only odometry gainsays, as
/// long as no other is clearly better.
std::optional<Match> EkfIcp::matchElsewhere(const Observations& observations) {
  std::optional<Match> best;
  double least = 0.0;  // inlier ratio that counts
  const auto tryAt = [&](const Pose2& guess) {
    const Match match = parts_.match(guess, observations.scan, Eigen::Matrix3d::Zero());
    if (!match.isGood() || match.inlier_ratio <= least) return;
    best = match;
    least = match.inlier_ratio;
  };
  if (candidate_) tryAt(*candidate_);
  if (best) return best;
  if (!anywhere_ && match_->fault == MatchFault::kJump) tryAt(match_->T_map_base);
  least *= kBetter;
  std::size_t tried = 0;
  for (const Place& place : parts_.places->search(observations)) {
    if (tried++ < kPlaces) tryAt(place.T_map_base);
  }
  return best;
}

}  // namespace adaptive_localization
