// SPDX-License-Identifier: BSD-3-Clause
// Draws the map of a floor plan: draw_map WORLD.yaml RESOLUTION MAP writes MAP.pgm and MAP.yaml.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "adaptive_localization/map/map_io.hpp"
#include "adaptive_localization/sim/rasterize.hpp"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr
        << "usage: draw_map WORLD.yaml RESOLUTION MAP\n"
           "Writes MAP.pgm and MAP.yaml from the floor plan; RESOLUTION in metres per cell.\n";
    return 1;
  }
  try {
    const auto plan = adaptive_localization::loadFloorPlan(argv[1]);
    const auto grid = adaptive_localization::rasterize(plan, std::atof(argv[2]));
    adaptive_localization::saveMap(grid, argv[3]);
  } catch (const std::exception& error) {
    std::cerr << "draw_map: " << error.what() << '\n';
    return 1;
  }
}
