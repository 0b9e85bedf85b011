// SPDX-License-Identifier: BSD-3-Clause
#include "pose_kalman.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/chi_square.hpp"
#include "particle/gaussian_cloud.hpp"

namespace adaptive_localization {
namespace {

Eigen::Vector3d off(const Pose2& from, const Pose2& to) {
  return {to.x - from.x, to.y - from.y, wrapAngle(to.theta - from.theta)};
}

Eigen::Matrix3d symmetric(const Eigen::Matrix3d& matrix) {
  return 0.5 * (matrix + matrix.transpose());
}

Eigen::LLT<PoseObservation::Square> innovationCovariance(const Eigen::Matrix3d& P,
                                                         const PoseObservation& observation) {
  const PoseObservation::Square S = observation.H * P * observation.H.transpose() + observation.R;
  return S.llt();
}

}  // namespace

PoseObservation observationOf(const Pose2& T_map_base, const Gaussian2& observed) {
  return {off(T_map_base, observed.mean), Eigen::Matrix3d::Identity(), observed.covariance};
}

PoseObservation observationOf(const Pose2& T_map_base, const Match& match) {
  return {match.H * off(T_map_base, match.T_map_base) + match.rest, match.H,
          match.variance.asDiagonal()};
}

void PoseKalman::reset(const Gaussian2& belief) {
  const Eigen::Matrix3d root = squareRoot(belief.covariance);
  belief_ = {belief.mean, symmetric(root * root.transpose())};
}

void PoseKalman::predict(const Pose2& motion, const Eigen::Matrix3d& noise) {
  const double c = std::cos(belief_.mean.theta);
  const double s = std::sin(belief_.mean.theta);
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(0, 2) = -s * motion.x - c * motion.y;
  F(1, 2) = c * motion.x - s * motion.y;
  Eigen::Matrix3d G = Eigen::Matrix3d::Identity();
  G.topLeftCorner<2, 2>() << c, -s, s, c;
  const Eigen::Matrix3d covariance =
      symmetric(F * belief_.covariance * F.transpose() + G * noise * G.transpose());
  if (covariance.allFinite()) belief_.covariance = covariance;
  belief_.mean = belief_.mean * motion;
}

double PoseKalman::distanceOf(const PoseObservation& observation) const {
  const auto S = innovationCovariance(belief_.covariance, observation);
  if (S.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  return observation.innovation.dot(S.solve(observation.innovation));
}

bool PoseKalman::correct(const PoseObservation& observation) {
  const Eigen::Matrix3d& P = belief_.covariance;
  const auto S = innovationCovariance(P, observation);
  if (S.info() != Eigen::Success) return false;
  const PoseObservation::Rows gain_transposed = S.solve(observation.H * P);
  const auto K = gain_transposed.transpose();
  const Eigen::Vector3d step = K * observation.innovation;
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - K * observation.H;
  const Eigen::Matrix3d covariance =
      symmetric(rest * P * rest.transpose() + K * observation.R * K.transpose());
  if (!step.allFinite() || !covariance.allFinite()) return false;
  belief_.mean = {belief_.mean.x + step.x(), belief_.mean.y + step.y(),
                  wrapAngle(belief_.mean.theta + step.z())};
  belief_.covariance = covariance;
  return true;
}

bool isOutlier(const PoseObservation& observation, const PoseKalman& belief) {
  static const double most[] = {0.0, chiSquare(1, 0.999), chiSquare(2, 0.999), chiSquare(3, 0.999)};
  return !(belief.distanceOf(observation) < most[observation.innovation.size()]);
}

void correctBy(const ObservationModel& senses, const Observations& observations,
               PoseKalman& belief) {
  for (std::size_t i = 0;; ++i) {  // each where those before have moved the belief to
    const auto seen = senses.linearized(observations, belief.mean());
    if (i >= seen.size()) return;  // there may be fewer than from the pose before
    if (!isOutlier(seen[i], belief)) belief.correct(seen[i]);
  }
}

bool areContradicting(const ObservationModel& senses, const Observations& observations,
                      const Gaussian2& belief) {
  PoseKalman kalman;
  kalman.reset(belief);
  const auto seen = senses.linearized(observations, kalman.mean());
  const auto outliers = std::count_if(
      seen.begin(), seen.end(),
      [&](const PoseObservation& observation) { return isOutlier(observation, kalman); });
  return 2 * outliers > static_cast<std::ptrdiff_t>(seen.size());
}

}  // namespace adaptive_localization
