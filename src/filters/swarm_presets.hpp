// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "presets.hpp"

namespace adaptive_localization {

/// What the source of the leader-based bat algorithm did with every swarm: 2000 searchers, 11
/// beams, the mean relative deviation, spread over the whole map, until 3 per cent or for 500
/// iterations; a fix is for good until odometry has drifted away from it.
Preset sourceOfSwarms();

/// Its bats: as printed, but for the sign.
Preset sourceOfBats();

/// Its leaders: one for 300 bats.
Preset sourceOfLeaders();

}  // namespace adaptive_localization
