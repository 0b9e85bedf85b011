// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adaptive_localization/map/map_file_error.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// Reads a map as map_server does: a YAML file (image, resolution, origin, negate, occupied_thresh,
/// free_thresh, optional mode: trinary, scale or raw) and the image it names, relative to the YAML.
/// Throws MapFileError.
OccupancyGrid loadMap(const std::string& yaml_file);

/// The files that a map is read from: its YAML file, and the image that it names. Throws
/// MapFileError.
std::vector<std::string> filesOfMap(const std::string& yaml_file);

/// Those that it is written to.
std::vector<std::string> filesToSave(const std::string& base);

/// Writes BASE.pgm and BASE.yaml as map_saver does (254 free, 0 occupied, 205 unknown).
/// Throws std::runtime_error naming the file that could not be written.
void saveMap(const OccupancyGrid& grid, const std::string& base);

}  // namespace adaptive_localization
