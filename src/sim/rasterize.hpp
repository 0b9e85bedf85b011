// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "map/floor_plan.hpp"

namespace adaptive_localization {

/// The map of a plan as a robot with a laser would make it: cells in which a surface lies are
/// occupied, since that is where beams end; of the others those with a free centre are free and the
/// rest is unknown. So a wall's surface is on the average in the middle of its cells, and exactly
/// there if it lies on a multiple of the resolution, m, and the lattice is not turned, rad.
/// Furniture is left out. The lattice bounds the outline with some cells to spare. Throws
/// std::invalid_argument for a resolution that gives no map, or one of more than 1e8 cells.
OccupancyGrid rasterize(const FloorPlan& plan, double resolution, double turn = 0.0);

}  // namespace adaptive_localization
