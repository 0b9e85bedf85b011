// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <ostream>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {

inline void PrintTo(const Pose2& pose, std::ostream* out) {
  *out << "(" << pose.x << ", " << pose.y << ", " << pose.theta << ")";
}

/// Position within so many metres, heading within so many radians the short way round.
MATCHER_P3(PoseNear, expected, metres, radians, "") {
  const double apart = distance(arg, expected);
  const double turned = std::abs(wrapAngle(arg.theta - expected.theta));
  *result_listener << "which is " << apart << " m and " << turned << " rad away";
  return apart <= metres && turned <= radians;
}

/// No number in it is NaN or infinite, masses are sorted and sum to 1, covariances are symmetric
/// and have no negative eigenvalue.
MATCHER(IsSaneEstimate, "") {
  const auto sane = [](const Eigen::Matrix3d& covariance) {
    if (!covariance.allFinite()) return false;
    const double tolerance = 1e-9 * (1.0 + covariance.cwiseAbs().maxCoeff());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    return (covariance - covariance.transpose()).cwiseAbs().maxCoeff() <= tolerance &&
           solver.eigenvalues().minCoeff() >= -tolerance;
  };
  double sum = 0.0;
  double previous = 1.0 + 1e-9;
  for (const Mode& mode : arg.modes) {
    if (!isFinite(mode.T_map_base) || !sane(mode.covariance)) return false;
    if (!(mode.mass >= 0.0) || mode.mass > previous + 1e-12) return false;
    sum += previous = mode.mass;
  }
  *result_listener << "whose masses sum to " << sum << " over " << arg.modes.size() << " modes";
  return isFinite(arg.T_map_base) && sane(arg.covariance) && std::abs(sum - 1.0) < 1e-6;
}

/// A pose somewhere in a square around zero.
inline Pose2 randomPose(Rng& rng, double side) {
  return {rng.uniform(-side, side), rng.uniform(-side, side), rng.uniform(-kPi, kPi)};
}

}  // namespace adaptive_localization
