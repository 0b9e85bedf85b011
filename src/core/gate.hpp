// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/belief.hpp"

namespace adaptive_localization {

/// What a filter says, and a few centimetres: clouds are narrower than they are right.
Eigen::Matrix3d loosened(Eigen::Matrix3d covariance);

/// Whether a pose is still of the place that a belief, loosened, means: 99 % of its poses are no
/// farther off, by Mahalanobis' distance.
bool isWithin(const Gaussian2& belief, const Pose2& T_map_base);

}  // namespace adaptive_localization
