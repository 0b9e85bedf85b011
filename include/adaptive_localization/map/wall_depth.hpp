// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// How far below its face a wall may be one, m: solid walls of plans end there, maps that were made
/// inexactly have hardly any that is deeper.
constexpr double kWallDepth = 0.35;

/// Mean depth of a map's walls, m, from the occupied cells and those of them at a face; 0 without
/// any. Walls two cells deep and thinner count as two: a laser saw their faces.
double wallDepth(const OccupancyGrid& map);

/// Whether walls are deeper than those that a laser saw from their sides: the map was made
/// inexactly, and what a laser sees is anywhere in them.
bool hasThickWalls(const OccupancyGrid& map);

/// The map with walls shrunk to about their middles: cells that are at least as deep as usual, and
/// the ridges of the others.
OccupancyGrid withThinWalls(const OccupancyGrid& map);

}  // namespace adaptive_localization
