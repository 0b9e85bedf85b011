// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/particles.hpp"

namespace adaptive_localization {

/// Mean and covariance of weighted poses over (x, y, theta). The mean heading is that of the mean
/// direction, atan2(sum w sin, sum w cos); its deviations are wrapped, so a cloud that straddles
/// +-pi is no wider than elsewhere. The mass is the sum of the weights.
Mode meanAndCovariance(const Particles& particles, const Eigen::ArrayXd& weights,
                       const std::vector<Eigen::Index>& members);

/// The modes of a cloud: clusters of neighbouring bins (half a metre, 10 degrees; headings wrap).
/// Pose and covariance come from the same, the heaviest, cluster. Modes are sorted by mass, which
/// sums to 1.
Estimate summarize(const Particles& particles, const Eigen::ArrayXd& weights);

}  // namespace adaptive_localization
