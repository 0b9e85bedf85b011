// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// The map with walls, so deep on average, m, shrunk to about their middles: cells that are at
/// least half as deep, and the ridges of the others.
OccupancyGrid withThinWalls(const OccupancyGrid& map, double wall_depth);

/// The map with hollow walls: of the occupied cells those that are not shut in by such on their
/// four sides.
OccupancyGrid withHollowWalls(const OccupancyGrid& map);

}  // namespace adaptive_localization
