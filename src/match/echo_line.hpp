// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "match/line_features.hpp"

namespace adaptive_localization {

/// An echo that a sonar heard, from where base is now.
struct SonarEcho {
  Eigen::Vector2d position;                        // of the sonar, m
  double course;                                   // of its axis, rad
  double range;                                    // m
  double half_view;                                // of its cone, rad
  double range_std;                                // m
  int sonar;                                       // which one
  double way{0.0};                                 // since, m
  Eigen::Matrix3d drift{Eigen::Matrix3d::Zero()};  // covariance of odometry since, in base now
};

/// How far an echo's arc is from touching a line that is farther, m; negative: it goes beyond.
double gapBetween(const SonarEcho& echo, double rho, double alpha);

/// Whether an echo can be one of a wall in a direction: it is within the cone, whose sides are
/// soft.
bool looksAt(const SonarEcho& echo, double alpha);

/// The line that the arcs of echoes touch, the oldest first, by weighted least squares from a
/// direction near it; nothing where that remains unsure or is not in all cones. See SonarLines.
std::optional<ScanLine> lineTouching(const std::vector<SonarEcho>& echoes, double alpha);

}  // namespace adaptive_localization
