// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/map/floor_plan.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// The map that a robot with a laser would make: cells in which a surface lies are occupied, since
/// that is where beams end; of the others those with a free centre are free and the rest is
/// unknown. So a wall's surface is on the average in the middle of its cells, not at their border
/// as in a map that was drawn (rasterize()). The lattice is turned by 0.1 rad, as nobody aligns it
/// with the walls. Furniture is left out. Throws std::invalid_argument for a resolution that gives
/// no map, or one of more than 1e8 cells.
OccupancyGrid survey(const FloorPlan& plan, double resolution);

}  // namespace adaptive_localization
