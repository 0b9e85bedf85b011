// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/pose_observation.hpp"
#include "adaptive_localization/observation/observation_model.hpp"
#include "match/scan_matcher.hpp"

namespace adaptive_localization {

/// All of the pose, observed as it is: H = I, headings wrapped.
PoseObservation observationOf(const Pose2& T_map_base, const Gaussian2& observed);

/// A matched scan as an observation: z = H x, with headings wrapped.
PoseObservation observationOf(const Pose2& T_map_base, const Match& match);

/// A Gaussian belief of the pose of base in map, and the extended Kalman filter's two steps
/// (Thrun, Burgard and Fox 2005, table 3.3). Covariances stay symmetric and positive.
class PoseKalman {
 public:
  /// Starts anew; a covariance that is none is mended.
  void reset(const Gaussian2& belief);

  /// Moves on by odometry, motion = T_previous_current with its noise Q in the previous pose's
  /// frame, G rotating it into the map's:
  ///
  ///     x' = x (+) u,   P' = F P F^T + G Q G^T
  void predict(const Pose2& motion, const Eigen::Matrix3d& noise);

  /// The squared Mahalanobis distance of an observation, nu^T S^-1 nu with S = H P H^T + R;
  /// infinite where S is singular.
  double distanceOf(const PoseObservation& observation) const;

  /// Takes note of an observation, in Joseph's form:
  ///
  ///     K = P H^T S^-1,   x' = x + K nu,   P' = (I - K H) P (I - K H)^T + K R K^T
  ///
  /// Does nothing, and says so, where S is singular.
  bool correct(const PoseObservation& observation);

  const Pose2& mean() const { return belief_.mean; }
  const Eigen::Matrix3d& covariance() const { return belief_.covariance; }
  const Gaussian2& belief() const { return belief_; }

 private:
  Gaussian2 belief_;
};

/// Whether an observation is beyond 99.9 % of what a belief lets expect, of a chi-square variable
/// with as many degrees of freedom.
bool isOutlier(const PoseObservation& observation, const PoseKalman& belief);

/// Corrects a belief by what the senses observed, but for outliers.
void correctBy(const ObservationModel& senses, const Observations& observations,
               PoseKalman& belief);

/// Whether most of what a sense observed cannot be where the robot is believed to be.
bool areContradicting(const ObservationModel& senses, const Observations& observations,
                      const Gaussian2& belief);

}  // namespace adaptive_localization
