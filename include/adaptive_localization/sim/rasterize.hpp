// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/map/floor_plan.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// The map a perfect survey would make: a cell is solid if its centre is (or if a wall's centre
/// line crosses it, so that no wall is lost in a coarse grid), occupied if it is solid and touches
/// a free cell, unknown if it is solid and does not. Furniture is left out. Surfaces are within
/// half a cell of the plan's. The lattice is the outline's bounding box and `margin` cells around
/// it.
OccupancyGrid rasterize(const FloorPlan& plan, double resolution, int margin = 5);

}  // namespace adaptive_localization
