// SPDX-License-Identifier: BSD-3-Clause
// Experiment E7: swarm_functions [SEEDS [PLOT.png]] compares swarms on test functions.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "adaptive_localization/eval/swarm_race.hpp"

namespace {

int toSeeds(const std::string& text) {
  char* end = nullptr;
  const long seeds = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || seeds < 1 || seeds > 100000) {
    throw std::invalid_argument("SEEDS: got '" + text +
                                "', expected a whole number from 1 to 100000");
  }
  return static_cast<int>(seeds);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 3) {
    std::cerr << "usage: swarm_functions [SEEDS [PLOT.png]]\n"
                 "Prints how many iterations swarms need on test functions; 50 seeds.\n";
    return 1;
  }
  try {
    const auto cells = adaptive_localization::raceSwarms(argc > 1 ? toSeeds(argv[1]) : 50);
    std::cout << adaptive_localization::toTable(cells);
    if (argc > 2) adaptive_localization::savePlot(cells, argv[2]);
  } catch (const std::exception& error) {
    std::cerr << "swarm_functions: " << error.what() << '\n';
    return 1;
  }
}
