// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace adaptive_localization {

/// What an observation says of the pose, to first order: innovation nu = z - h(x), its Jacobian
/// H = dh/d(x, y, theta), and the observation's covariance R; k <= 3 rows.
struct PoseObservation {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

  Vector innovation;
  Rows H;
  Square R;
};

}  // namespace adaptive_localization
