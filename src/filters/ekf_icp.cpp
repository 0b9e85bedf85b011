// SPDX-License-Identifier: BSD-3-Clause
#include "ekf_icp.hpp"

#include <algorithm>
#include <cmath>

#include "adaptive_localization/particle/resampling.hpp"
#include "adaptive_localization/particle/summary.hpp"
#include "particle/gaussian_cloud.hpp"

namespace adaptive_localization {
namespace {

constexpr double kJump = 0.5;           // m, rad: odometry that may have jumped,
constexpr double kFast = 2.0;           // m/s, rad/s: if it did so faster than robots drive
constexpr double kBetter = 1.2;         // inlier ratio of a place against that of one at hand
constexpr double kNewPlaceStd = 0.05;   // m, of a place just found, beyond what the match says
constexpr double kNewPlaceTurn = 0.02;  // rad

Gaussian2 newPlace(const Pose2& T_map_base) {
  return {T_map_base, Eigen::Vector3d(kNewPlaceStd * kNewPlaceStd, kNewPlaceStd * kNewPlaceStd,
                                      kNewPlaceTurn * kNewPlaceTurn)
                          .asDiagonal()};
}

bool mayBeJump(const Pose2& motion, double seconds) {
  const double most = std::max(distance({}, motion), std::abs(motion.theta));
  return most > kJump && most > kFast * seconds;
}

Gaussian2 heaviestOf(const Particles& cloud) {
  const Estimate all = summarize(cloud, normalisedWeights(cloud.log_weight));
  return {all.T_map_base, all.covariance};
}

}  // namespace

void EkfIcp::reset(const Prior& prior) {
  refused_ = 0;
  way_ = 0.0;
  pending_.finish();
  match_.reset();
  if (parts_.sonars) parts_.sonars->forget();
  anywhere_ = std::holds_alternative<Anywhere>(prior);
  const auto* cloud = std::get_if<Particles>(&prior);
  if (cloud && cloud->size() > 0) {
    tracker_.reset(heaviestOf(*cloud));
  } else if (const auto* gaussian = std::get_if<Gaussian2>(&prior)) {
    tracker_.reset(*gaussian);
  } else {
    anywhere_ = true;
    parts_.elsewhere->condition(Observations{});  // forgets what was seen before
    cloud_ = Particles(10 * options_.cloud_particles);
    for (Eigen::Index i = 0; i < cloud_.size(); ++i) {
      cloud_.setPose(i, parts_.elsewhere->draw(rng_));
    }
    tracker_.reset(heaviestOf(cloud_));
    return;
  }
  cloud_ = drawCloud(tracker_.belief(), options_.cloud_particles, rng_);
}

Estimate EkfIcp::estimate() const {
  const Gaussian2& belief = tracker_.belief();
  return {belief.mean, belief.covariance, {{belief.mean, belief.covariance, 1.0}}};
}

Estimate EkfIcp::update(const Pose2& motion, const Observations& observations) {
  const Pose2 before = tracker_.mean();
  move(pending_.rest(motion));
  pending_.move(motion);
  if (anywhere_) startAt(observations);
  tracker_.correctBy(*parts_.senses, observations);
  if (parts_.sonars && !anywhere_) correctBySonars(observations);
  match_ = tracker_.matchAt(tracker_.mean(), observations.scan);
  if (mayBeJump(motion, observations.stamp - stamp_)) undoJump(before, observations.scan);
  stamp_ = observations.stamp;
  if (anywhere_ && match_->isGood()) match_->fault = MatchFault::kNoGuess;
  if (parts_.scans && match_->isGood()) match_->fault = MatchFault::kSlides;
  correct();
  way_ += std::max(distance({}, motion), std::abs(motion.theta));
  if (match_->fault == MatchFault::kSlides) weighCloud(observations);
  if (!anywhere_) cloud_ = drawCloud(tracker_.belief(), options_.cloud_particles, rng_);
  pending_.finish();
  return estimate();
}

void EkfIcp::move(const Pose2& motion) {
  if (!isPlausible(motion)) return;
  const Eigen::Matrix3d noise = parts_.motion->covariance(motion);
  tracker_.predict(motion, noise);
  if (parts_.sonars) parts_.sonars->move(motion, noise);
}

/// Each echo has corrected the pose by itself before, so that a wall which disagrees with those is
/// refused, and one that agrees is not counted in full.
void EkfIcp::correctBySonars(const Observations& observations) {
  constexpr double kHeardBefore = 2.0;  // times an echo counts
  for (const LineMatch& match : parts_.sonars->listen(observations.sonar, tracker_.belief())) {
    const PoseObservation seen{match.innovationAt(tracker_.mean()), match.H,
                               kHeardBefore * match.R};
    if (!tracker_.isOutlier(seen)) tracker_.correct(seen);
  }
}

/// Where the first scan fits best: poses are drawn there, and the heaviest cluster is believed.
void EkfIcp::startAt(const Observations& observations) {
  if (!parts_.elsewhere->condition(observations)) return;
  Particles cloud(options_.cloud_particles);
  for (Eigen::Index i = 0; i < cloud.size(); ++i) cloud.setPose(i, parts_.elsewhere->draw(rng_));
  tracker_.reset(newPlace(heaviestOf(cloud).mean));
  anywhere_ = false;
}

/// Odometry can jump by a metre while the robot stands: the scan tells.
void EkfIcp::undoJump(const Pose2& T_map_base_before, const Scan& scan) {
  if (parts_.sonars) parts_.sonars->forget();
  const Match stayed = tracker_.matchAt(T_map_base_before, scan);
  if (!stayed.isGood() || stayed.inlier_ratio < kBetter * match_->inlier_ratio) return;
  tracker_.reset({T_map_base_before, tracker_.covariance()});
  match_ = stayed;
}

void EkfIcp::weighCloud(const Observations& observations) {
  constexpr double kNewWay = 0.1;          // m or rad
  constexpr double kLeastEffective = 0.1;  // share of the cloud
  if (way_ < kNewWay) return;
  Particles cloud = drawCloud(tracker_.belief(), options_.cloud_particles, rng_);
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(cloud.size());
  if (parts_.scans->score(observations, cloud, log_likelihood) <= 0.0) return;
  const Eigen::ArrayXd equal = normalisedWeights(cloud.log_weight);
  cloud.log_weight = temperedWeights(equal, log_likelihood, kLeastEffective).log();
  tracker_.reset(heaviestOf(cloud));
  way_ = 0.0;
}

/// By the match; says what is wrong with it if it does not correct.
void EkfIcp::correct() {
  const auto is_near = [this](const Match& match) { return tracker_.distanceOf(match) < gate_; };
  if (tracker_.correct(*match_, is_near)) {
    refused_ = 0;
  } else if (match_->fault == MatchFault::kJump && ++refused_ >= options_.ekf_rejected_scans) {
    tracker_.reset(newPlace(match_->T_map_base));
    refused_ = 0;
  }
}

}  // namespace adaptive_localization
