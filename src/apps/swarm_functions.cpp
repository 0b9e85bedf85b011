// SPDX-License-Identifier: BSD-3-Clause
// Experiment E7: compares swarms on test functions.
#include <exception>
#include <iostream>

#include "adaptive_localization/eval/swarm_command.hpp"
#include "adaptive_localization/eval/swarm_race.hpp"

namespace al = adaptive_localization;

int main(int argc, char** argv) {
  try {
    const auto command = al::parseSwarmFunctions({argv + 1, argv + argc});
    if (command.wants_help) {
      std::cout << al::swarmFunctionsUsage();
      return 0;
    }
    const auto cells = al::raceSwarms(command.seeds, command.first_seed);
    std::cout << al::toTable(cells);
    if (!command.json_file.empty()) al::saveJson(cells, command.json_file);
    if (!command.plot_file.empty()) al::savePlot(cells, command.plot_file);
  } catch (const std::exception& error) {
    std::cerr << "swarm_functions: " << error.what() << "\nTry swarm_functions --help\n";
    return 1;
  }
}
