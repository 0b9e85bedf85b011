// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "ser/energy_grid.hpp"

namespace adaptive_localization {

/// Draws the map with the mean energy over the headings of each cell of a grid, whose sensor is
/// base. Throws std::runtime_error naming the file that could not be written.
void saveEnergies(const OccupancyGrid& map, const EnergyGrid& grid, const std::string& file);

/// Draws the map with the share of each cell's headings that are in a region, and the pose where
/// the scan was taken.
void saveRegion(const OccupancyGrid& map, const EnergyGrid& grid, const EnergyGrid::Region& region,
                const Pose2& T_map_base, const std::string& file);

}  // namespace adaptive_localization
