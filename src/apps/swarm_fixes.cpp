// SPDX-License-Identifier: BSD-3-Clause
// Experiments E8 to E11: swarm_fixes WORLD.yaml RESOLUTION [RUNS [torus]] compares swarms that look
// for the place of one scan.
#include "adaptive_localization/eval/swarm_fixes.hpp"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  adaptive_localization::SwarmFixPlan plan;
  if (argc > 2) plan.resolution = std::atof(argv[2]);
  if (argc > 3) plan.runs = std::atoi(argv[3]);
  plan.is_torus = argc > 4 && std::string(argv[4]) == "torus";
  if (argc < 3 || argc > 5 || plan.runs < 1 || (argc > 4 && !plan.is_torus)) {
    std::cerr << "usage: swarm_fixes WORLD.yaml RESOLUTION [RUNS [torus]]\n"
                 "Compares swarms that look for the place of one scan of 11 beams; 30 runs.\n";
    return 1;
  }
  try {
    plan.world = argv[1];
    std::cout << adaptive_localization::toTable(adaptive_localization::raceFixes(plan));
  } catch (const std::exception& error) {
    std::cerr << "swarm_fixes: " << error.what() << '\n';
    return 1;
  }
}
