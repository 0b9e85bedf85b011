// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/experiment_loader.hpp"
#include "eval/experiment_plan.hpp"

namespace adaptive_localization {

/// What the user asked `experiments` for.
struct ExperimentCommand {
  std::vector<std::string> files;
  std::string out_file;
  int jobs{1};
  Shard shard;
  std::optional<int> seeds;
  std::vector<std::string> words;  // only runs that have one of them in their name
  Overrides overrides;
  bool is_list{false};
  bool is_quiet{false};
  bool wants_help{false};
};

/// The usage text.
std::string experimentUsage();

/// Reads the arguments, the program's name not among them.
/// Throws std::invalid_argument naming the argument, the value and what was expected.
ExperimentCommand parseExperimentCommand(const std::vector<std::string>& arguments);

}  // namespace adaptive_localization
