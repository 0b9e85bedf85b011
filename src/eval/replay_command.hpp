// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "eval/log.hpp"
#include "eval/spoil.hpp"

namespace adaptive_localization {

/// What the user asked `replay` for.
struct ReplayCommand {
  std::string map;
  LogRequest log;
  Parameters parameters;  // --params in order, then --set, then --filter, --seed, --threads
  std::vector<std::string> parameter_files;  // of --params
  std::string start;  // truth, global or X,Y,YAW; empty: truth where there is one
  std::string truth_file;
  std::optional<Pose2> T_base_laser;  // in place of what the log says
  std::string trajectory_file, json_file, report_folder;
  std::vector<Spoil> spoils;
  std::optional<int> spoil_seed;  // none: the run's
  int search{0};                  // scans to be searched instead
  bool allows_misfit{false};      // ends well though the scans fit the map nowhere
  bool is_quiet{false};
  bool wants_help{false};
};

/// The usage text.
std::string replayUsage();

/// Reads the arguments, the program's name not among them.
/// Throws std::invalid_argument naming the argument, the value and what was expected.
ReplayCommand parseReplayCommand(const std::vector<std::string>& arguments);

}  // namespace adaptive_localization
