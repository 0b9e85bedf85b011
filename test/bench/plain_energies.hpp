// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// The yardstick for energy grids: for each free cell, heading and beam, march in steps of a cell
/// until there is an obstacle, as the SAMCL and SA-KLD papers do. Beams are 6 degrees apart.
/// [cell * headings + heading]
std::vector<float> plainEnergies(const OccupancyGrid& map, int headings, int beams,
                                 double max_range);

}  // namespace adaptive_localization
