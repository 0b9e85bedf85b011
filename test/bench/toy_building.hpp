// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// A square building for measurements: rooms of 8 m with doors and some boxes, 5 cm cells, walls
/// two cells thick, closed all round, so that every beam hits something.
std::shared_ptr<const OccupancyGrid> toyBuilding(int cells_per_side);

/// Where the robot stands in it.
constexpr Pose2 kTruth{5.3, 4.1, 0.4};

/// A scan of 360 degrees with 1 cm of noise, taken at a pose; all beams are hits.
Observations observe(const std::shared_ptr<const OccupancyGrid>& map, const Pose2& T_map_base,
                     int beams);

enum class Spread { kTracking, kGlobal };

/// Particles around the truth (standard deviations 0.2 m and 0.1 rad) or anywhere in free space.
Particles spread(Spread kind, Eigen::Index count, const std::shared_ptr<const OccupancyGrid>& map);

}  // namespace adaptive_localization
