// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "eval/damage.hpp"

namespace adaptive_localization {

/// What maps in use suffer from.
const Damages<OccupancyGrid>& mapDamages();

/// The map made as poor as that, in the same frame; the same for the same seed.
/// Throws std::invalid_argument listing the known kinds, or naming the amount's range.
OccupancyGrid spoil(const OccupancyGrid& map, const std::string& kind, double amount,
                    std::uint64_t seed);

}  // namespace adaptive_localization
