// SPDX-License-Identifier: BSD-3-Clause
#include "core/gate.hpp"

#include <Eigen/Dense>

#include "core/chi_square.hpp"

namespace adaptive_localization {

Eigen::Matrix3d loosened(Eigen::Matrix3d covariance) {
  constexpr double kStd = 0.05;  // m, and as much in rad
  covariance.diagonal().array() += kStd * kStd;
  return covariance;
}

bool isWithin(const Gaussian2& belief, const Pose2& T_map_base) {
  static const double kGate = chiSquare(3, 0.99);
  const Pose2& mean = belief.mean;
  const Eigen::Vector3d off(T_map_base.x - mean.x, T_map_base.y - mean.y,
                            wrapAngle(T_map_base.theta - mean.theta));
  return off.dot(loosened(belief.covariance).llt().solve(off)) < kGate;
}

}  // namespace adaptive_localization
