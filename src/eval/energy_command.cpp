// SPDX-License-Identifier: BSD-3-Clause
#include "eval/energy_command.hpp"

#include <cstdio>
#include <stdexcept>

#include "eval/arguments.hpp"

namespace adaptive_localization {
namespace {

Pose2 readQuery(const std::string& text) {
  Pose2 pose;
  char rest{};
  const int read = std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &pose.x, &pose.y, &pose.theta, &rest);
  if (read != 3 || !isFinite(pose)) {
    throw std::invalid_argument("--query: got '" + text + "', expected X,Y,YAW in m and rad");
  }
  return pose;
}

}  // namespace

std::string energyUsage() {
  return R"(usage: energy_grid --map MAP.yaml [options]

Builds the energy grid of a map and tells what is in it.

  --beams N          beams that an energy is made of (default 30)
  --orientations N   headings in each cell (default 18)
  --max-range R      ranges are cut off here, m (default 10)
  --view DEG         what the laser sees, all round is 360 (default 180)
  --png FILE         draw the mean energy of each cell; with --query, the region of the scan
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
  parser.text("--png", command.picture);
  parser.option("--query", [&](const auto& v) { command.query = readQuery(v); });
  parser.option("--view", [&](const auto& v) {
    command.view = toNumber("--view", v, {1.0, 360.0}, "1 to 360 degrees");
  });
  option("--beams", "energy_beams");
  option("--orientations", "energy_orientations");
  option("--max-range", "energy_max_range");
  command.wants_help = !parser.parse(arguments);
  if (command.wants_help) return command;
  if (command.map.empty()) throw std::invalid_argument("--map is missing");
  return command;
}

}  // namespace adaptive_localization
