// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// A Gaussian over poses of base in map; covariance over (x, y, theta) in m^2, m rad, rad^2.
struct Gaussian2 {
  Pose2 mean;
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
};

/// Uniform over the map's free cells and all headings.
struct Anywhere {};

/// What is believed before the first observation. Particles are a belief taken over from another
/// filter: those that know no particles of their own can start from summarize()'s heaviest mode.
using Prior = std::variant<Gaussian2, Anywhere, Particles>;

/// One place where the robot may be.
struct Mode {
  Pose2 T_map_base;
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};  // of this mode alone
  double mass{0.0};                                     // share of the belief, in [0, 1]
};

/// What a filter believes: the heaviest mode, and all modes, heaviest first (never empty).
struct Estimate {
  Pose2 T_map_base;
  Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
  std::vector<Mode> modes;
  double share_elsewhere{0.0};  // of the hypotheses, drawn elsewhere after this update
};

}  // namespace adaptive_localization
