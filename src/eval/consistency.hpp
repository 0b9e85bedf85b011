// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// The normalised estimation error squared (NEES), e^T P^-1 e, of a pose's error e = truth -
/// estimate, heading wrapped, and the covariance P over (x, y, theta) that came with the estimate.
/// Where covariances mean what they say it has a chi-square distribution with 3 degrees of freedom:
/// 3 on the average; more is overconfident, less is cautious (Bar-Shalom, Li and Kirubarajan,
/// Estimation with Applications to Tracking and Navigation, 2001, 5.4.2). None for a covariance
/// that is not positive definite.
std::optional<double> normalizedError(const Pose2& estimate, const Eigen::Matrix3d& covariance,
                                      const Pose2& truth);

/// Both ends included.
struct Band {
  double low{0.0};
  double high{0.0};

  bool contains(double value) const { return value >= low && value <= high; }
};

/// In which the average normalised error of so many independent runs lies with this probability, if
/// the filter is consistent: the two-sided quantiles of chi-square with 3 N degrees of freedom,
/// over N. Throws std::invalid_argument for less than one run or no probability between 0 and 1.
Band consistencyBand(int runs, double probability = 0.95);

}  // namespace adaptive_localization
