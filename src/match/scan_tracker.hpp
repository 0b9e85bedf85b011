// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>

#include "adaptive_localization/core/scan.hpp"
#include "match/pose_kalman.hpp"

namespace adaptive_localization {

/// Aligns a scan with the map from a guess and the information over (x, y, theta) that it has.
using MatchScan =
    std::function<Match(const Pose2& guess, const Scan& scan, const Eigen::Matrix3d& prior)>;

/// By a matcher of hits or of lines.
template <class Matcher>
MatchScan matchBy(Matcher matcher) {
  return [matcher = std::move(matcher)](const Pose2& guess, const Scan& scan,
                                        const Eigen::Matrix3d& prior) {
    return matcher.match(guess, scan, prior);
  };
}

/// Whether a matched pose may correct the belief.
using MatchGate = std::function<bool(const Match& match)>;

/// Follows a pose by odometry and matched scans: predict, match, gate, correct. A core that has no
/// use for matches gives none and does not ask for them.
class ScanTracker {
 public:
  explicit ScanTracker(MatchScan match = {}) : match_(std::move(match)) {}

  void reset(const Gaussian2& belief) { kalman_.reset(belief); }

  /// Moves on by odometry, motion = T_previous_current, with its noise.
  void predict(const Pose2& motion, const Eigen::Matrix3d& noise) {
    kalman_.predict(motion, noise);
  }

  /// Corrects the belief by what other senses than the laser observed.
  void correctBy(const ObservationModel& senses, const Observations& observations) {
    adaptive_localization::correctBy(senses, observations, kalman_);
  }

  /// A scan aligned with the map from a pose on, with the belief's covariance for a prior.
  Match matchAt(const Pose2& T_map_base, const Scan& scan) const;

  /// Whether the belief cannot explain an observation.
  bool isOutlier(const PoseObservation& seen) const {
    return adaptive_localization::isOutlier(seen, kalman_);
  }

  /// Corrects the belief by an observation of the pose; false where that is singular.
  bool correct(const PoseObservation& seen) { return kalman_.correct(seen); }

  /// Corrects the belief by a match if it is good and passes the gate; says kJump if it does not.
  bool correct(Match& match, const MatchGate& gate);

  /// The squared Mahalanobis distance of a match from the belief.
  double distanceOf(const Match& match) const {
    return kalman_.distanceOf(observationOf(kalman_.mean(), match));
  }

  const Gaussian2& belief() const { return kalman_.belief(); }
  const Pose2& mean() const { return kalman_.mean(); }
  const Eigen::Matrix3d& covariance() const { return kalman_.covariance(); }

 private:
  MatchScan match_;
  PoseKalman kalman_;
};

}  // namespace adaptive_localization
