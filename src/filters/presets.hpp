// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// Values of options where they differ from our defaults.
using Preset = std::map<std::string, OptionValue>;

/// The first one's values where both have one.
Preset operator+(Preset first, const Preset& second);

/// What the source of mcl, kld, samcl and sa_kld used on its Pioneer 3-DX: constant motion noise,
/// 30 beams up to 10 m and ray casting, an update per odometry step.
Preset sourceOfAll();

/// Its KLD-sampling: bins of two cells of 0.15 m in x and y only.
Preset sourceOfKld();

/// Its test for kidnapping: the largest unnormalised weight 1 / sum_i |z_i* - z_i| is below 0.045
/// with 30 beams, and 70 % stay.
Preset sourceOfSamcl();

/// The source of ekf_icp: point-to-point ICP, all that is within a metre, no doubts.
Preset sourceOfEkfIcp();

/// amcl as it is shipped.
Preset stockAmcl();

}  // namespace adaptive_localization
