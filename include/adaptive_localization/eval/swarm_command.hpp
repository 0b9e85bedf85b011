// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adaptive_localization/eval/swarm_fixes.hpp"

namespace adaptive_localization {

/// What the user asked `swarm_functions` for.
struct SwarmFunctionsCommand {
  int seeds{50};
  int first_seed{1};
  std::string plot_file, json_file;
  bool wants_help{false};
};

/// What the user asked `swarm_fixes` for.
struct SwarmFixesCommand {
  SwarmFixPlan plan;
  std::string json_file;
  bool wants_help{false};
};

std::string swarmFunctionsUsage();
std::string swarmFixesUsage();

/// Read the arguments, the program's name not among them.
/// Throw std::invalid_argument naming the argument, the value and what was expected.
SwarmFunctionsCommand parseSwarmFunctions(std::vector<std::string> arguments);
SwarmFixesCommand parseSwarmFixes(std::vector<std::string> arguments);

}  // namespace adaptive_localization
