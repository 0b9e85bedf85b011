// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "eval/experiment.hpp"
#include "eval/experiment_result.hpp"

namespace adaptive_localization {

/// One run to be made. Points into the experiments it was planned from.
struct PlannedRun {
  const ExperimentCase* of_case;
  const ExperimentCore* core;
  int seed;

  RunId id() const;
};

/// Part i of n of all runs, counted from 1.
struct Shard {
  std::size_t index{1};
  std::size_t count{1};
};

/// All runs, case by case and core by core; of a shard every n-th. Where words are given, only runs
/// that have one of them in "experiment/case/core$", where $ is the end.
std::vector<PlannedRun> planRuns(const std::vector<Experiment>& experiments, const Shard& shard,
                                 const std::vector<std::string>& words);

/// Makes runs on so many threads at once and hands over each result as it comes, one at a time.
/// What goes wrong in a run is thrown as std::runtime_error naming it, once the runs under way are
/// done.
void makeRuns(const std::vector<PlannedRun>& runs, int jobs,
              const std::function<void(const ExperimentResult&)>& take);

}  // namespace adaptive_localization
