// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "eval/experiment_command.hpp"
#include "eval/experiment_file.hpp"
#include "eval/program.hpp"
#include "eval/progress_bar.hpp"

namespace adaptive_localization {
namespace {

std::vector<Experiment> load(const ExperimentCommand& command) {
  std::vector<Experiment> experiments;
  for (const auto& file : command.files) {
    experiments.push_back(loadExperiment(file, command.overrides));
    for (auto& of_case : experiments.back().cases) {
      if (command.seeds) of_case.seeds = *command.seeds;
    }
  }
  return experiments;
}

void list(const std::vector<PlannedRun>& runs) {
  std::map<std::string, int> counts;
  for (const auto& run : runs) {
    ++counts[run.of_case->experiment + "/" + run.of_case->label + "/" + run.core->label];
  }
  for (const auto& [name, count] : counts) std::cout << name << ": " << count << " runs\n";
}

void run(const ExperimentCommand& command) {
  const auto experiments = load(command);
  const auto runs = planRuns(experiments, command.shard, command.words);
  if (!command.words.empty() && planRuns(experiments, {}, command.words).empty()) {
    throw std::invalid_argument("--only: got '" + command.words.front() +
                                "', expected a word of what --list shows without it");
  }
  if (command.is_list) return list(runs);
  ExperimentFile file(command.out_file);
  const auto missing = file.missing(runs);
  if (!command.is_quiet && missing.size() < runs.size()) {
    std::cerr << "experiments: " << runs.size() - missing.size() << " of " << runs.size()
              << " runs are there already\n";
  }
  ProgressBar bar(missing.size(), !command.is_quiet, "runs");
  std::size_t done = 0;
  makeRuns(missing, command.jobs, [&](const ExperimentResult& result) {
    file.add(result);
    bar.show(++done);
  });
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("experiments", al::experimentUsage(), al::parseExperimentCommand, al::run,
                        {argv + 1, argv + argc});
}
