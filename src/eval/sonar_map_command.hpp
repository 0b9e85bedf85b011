// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "eval/log.hpp"
#include "eval/sonar_drive.hpp"
#include "map/evidence_grid.hpp"

namespace adaptive_localization {

/// What the user asked `sonar_map` for.
struct SonarMapCommand {
  std::string world;                                // of a simulated drive; else
  LogRequest log;                                   // a recorded one
  std::string poses_file;                           // of that; empty: its reference or odometry
  std::string truth;                                // the true map's file
  std::string out_folder, json_file, profile_file;  // empty: not wanted
  std::vector<std::string> models;
  double seconds{300.0};
  double resolution{0.05};  // m per cell
  Poses poses{Poses::kTruth};
  SimulationOptions simulation;
  EvidenceOptions evidence;
  bool is_quiet{false};
  bool wants_help{false};
};

/// The usage text.
std::string sonarMapUsage();

/// Reads the arguments, the program's name not among them.
/// Throws std::invalid_argument naming the argument, the value and what was expected.
SonarMapCommand parseSonarMapCommand(const std::vector<std::string>& arguments);

}  // namespace adaptive_localization
