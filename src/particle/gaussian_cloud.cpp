// SPDX-License-Identifier: BSD-3-Clause
#include "particle/gaussian_cloud.hpp"

#include <Eigen/Eigenvalues>

namespace adaptive_localization {

Eigen::Matrix3d squareRoot(const Eigen::Matrix3d& covariance) {
  if (!covariance.allFinite()) return Eigen::Matrix3d::Zero();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      0.5 * (covariance + covariance.transpose()));
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

Particles drawCloud(const Gaussian2& gaussian, Eigen::Index count, Rng& rng) {
  Particles cloud(count);
  const Eigen::Matrix3d root = squareRoot(gaussian.covariance);
  const Pose2& mean = gaussian.mean;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d d = root * Eigen::Vector3d(rng.normal(), rng.normal(), rng.normal());
    cloud.setPose(i, {mean.x + d.x(), mean.y + d.y(), wrapAngle(mean.theta + d.z())});
  }
  return cloud;
}

}  // namespace adaptive_localization
