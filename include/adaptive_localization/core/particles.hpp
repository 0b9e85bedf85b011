// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Weighted poses of base in map, in columns: metres, radians, natural logarithms of weights.
struct Particles {
  Particles() = default;
  explicit Particles(Eigen::Index count)
      : x(Eigen::ArrayXd::Zero(count)),
        y(Eigen::ArrayXd::Zero(count)),
        theta(Eigen::ArrayXd::Zero(count)),
        log_weight(Eigen::ArrayXd::Zero(count)) {}

  Eigen::Index size() const { return x.size(); }
  Pose2 pose(Eigen::Index i) const { return {x[i], y[i], theta[i]}; }
  void setPose(Eigen::Index i, const Pose2& pose) {
    x[i] = pose.x;
    y[i] = pose.y;
    theta[i] = pose.theta;
  }

  Eigen::ArrayXd x, y, theta, log_weight;
};

}  // namespace adaptive_localization
