// SPDX-License-Identifier: BSD-3-Clause
// Experiments E8 to E11: compares swarms that look for the place of one scan.
#include <exception>
#include <iostream>

#include "adaptive_localization/eval/swarm_command.hpp"

namespace al = adaptive_localization;

int main(int argc, char** argv) {
  try {
    const auto command = al::parseSwarmFixes({argv + 1, argv + argc});
    if (command.wants_help) {
      std::cout << al::swarmFixesUsage();
      return 0;
    }
    const auto cells = al::raceFixes(command.plan);
    std::cout << al::toTable(cells);
    if (!command.json_file.empty()) al::saveJson(cells, command.json_file);
  } catch (const std::exception& error) {
    std::cerr << "swarm_fixes: " << error.what() << "\nTry swarm_fixes --help\n";
    return 1;
  }
}
