// SPDX-License-Identifier: BSD-3-Clause
#include "eval/energy_command.hpp"

#include <stdexcept>

#include "eval/arguments.hpp"
#include "eval/start.hpp"

namespace adaptive_localization {

std::string energyUsage() {
  return R"(usage: energy_grid --map MAP.yaml [options]

Builds the energy grid of a map and tells what is in it.

  --beams N          beams that an energy is made of (default 30)
  --orientations N   headings in each cell (default 18)
  --pitch R          distance between neighbouring positions, m; 0: every cell (the default)
  --max-range R      ranges are cut off here, m (default 10)
  --view DEG         what the laser sees, all round is 360 (default 180)
  --json FILE        write the mean energy of each cell and, with --query, its share in the region
                     of the scan; scripts/draw FILE draws that
  --query X,Y,YAW    simulate a scan there (m, rad), find its region and the places it fits
  --help             print this
)";
}

EnergyCommand parseEnergyCommand(const std::vector<std::string>& arguments) {
  EnergyCommand command;
  ArgumentParser parser;
  const auto option = [&](const char* name, const char* key) {
    parser.option(name, [&command, key](const auto& v) { command.options.set(key, v); });
  };
  parser.text("--map", command.map);
  parser.text("--json", command.json_file);
  parser.option("--query", [&](const auto& v) {
    command.query = toPose("--query", v, "X,Y,YAW in m and rad");
  });
  parser.option("--view", [&](const auto& v) {
    command.view = toNumber("--view", v, {1.0, 360.0}, "1 to 360 degrees");
  });
  option("--beams", "energy_beams");
  option("--orientations", "energy_orientations");
  option("--pitch", "energy_grid_pitch");
  option("--max-range", "energy_max_range");
  command.wants_help = !parser.parse(arguments);
  if (command.wants_help) return command;
  if (command.map.empty()) throw std::invalid_argument("--map is missing");
  return command;
}

}  // namespace adaptive_localization
