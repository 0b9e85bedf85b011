// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {

/// A square root R of a covariance, R R^T, that may be singular. What is negative counts as 0, a
/// covariance that is not finite as no spread at all.
Eigen::Matrix3d squareRoot(const Eigen::Matrix3d& covariance);

/// Particles of equal weight drawn from a Gaussian.
Particles drawCloud(const Gaussian2& gaussian, Eigen::Index count, Rng& rng);

}  // namespace adaptive_localization
