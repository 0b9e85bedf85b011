// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "match/surface.hpp"

namespace adaptive_localization {

/// A piece of wall and the cell that it was found in.
struct FittedSurface {
  Cell cell;
  Surface surface;
};

/// Lines through the occupied cells that free ground touches, each through those around one cell
/// that are seen from the same side; none where they make no line.
std::vector<FittedSurface> fitSurfaces(const OccupancyGrid& grid);

}  // namespace adaptive_localization
