// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// What the user asked `energy_grid` for.
struct EnergyCommand {
  std::string map, json_file;
  std::optional<Pose2> query;  // of the laser in map
  double view{180.0};          // degrees
  Parameters options;          // of the energy grid
  bool wants_help{false};
};

/// The usage text.
std::string energyUsage();

/// Reads the arguments, the program's name not among them.
/// Throws std::invalid_argument naming the argument, the value and what was expected.
EnergyCommand parseEnergyCommand(const std::vector<std::string>& arguments);

}  // namespace adaptive_localization
