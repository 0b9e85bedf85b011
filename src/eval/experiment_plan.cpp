// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_plan.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "eval/experiment_run.hpp"
#include "fingerprint.hpp"

namespace adaptive_localization {
namespace {

bool hasWord(const std::string& name, const std::vector<std::string>& words) {
  const std::string ended = name + '$';
  return words.empty() || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
           return ended.find(word) != std::string::npos;
         });
}

using Sites = std::map<const ExperimentCase*, ExperimentSite>;

/// Loads every case's world and checks every core in it.
Sites prepare(const std::vector<PlannedRun>& runs) {
  Sites sites;
  std::set<std::pair<const ExperimentCase*, const ExperimentCore*>> checked;
  for (const auto& run : runs) {
    if (!sites.count(run.of_case)) sites.emplace(run.of_case, loadSite(*run.of_case));
    if (checked.emplace(run.of_case, run.core).second) {
      checkCore(sites.at(run.of_case), *run.of_case, *run.core);
    }
  }
  return sites;
}

ExperimentResult make(const PlannedRun& run, const ExperimentSite& site) {
  try {
    ExperimentResult result = runExperiment(site, *run.of_case, *run.core, run.seed);
    result.id = run.id();
    return result;
  } catch (const std::exception& error) {
    throw std::runtime_error(run.id().name() + ", seed " + std::to_string(run.seed) + ": " +
                             error.what());
  }
}

}  // namespace

RunId PlannedRun::id() const {
  const std::string settings = hashOf(of_case->fingerprint + fingerprint(core->parameters));
  return {of_case->experiment, of_case->label, core->label, seed, settings};
}

std::vector<PlannedRun> planRuns(const std::vector<Experiment>& experiments, const Shard& shard,
                                 const std::vector<std::string>& words) {
  std::vector<PlannedRun> runs;
  std::size_t count = 0;
  for (const auto& experiment : experiments) {
    for (const auto& of_case : experiment.cases) {
      for (const auto& core : of_case.cores) {
        for (int i = 0; i < of_case.seeds; ++i) {
          const PlannedRun run{&of_case, &core, of_case.first_seed + i};
          const RunId id{experiment.name, of_case.label, core.label, 0, ""};
          if (!hasWord(id.name(), words)) continue;
          if (count++ % shard.count == shard.index - 1) runs.push_back(run);
        }
      }
    }
  }
  return runs;
}

void makeRuns(const std::vector<PlannedRun>& runs, int jobs,
              const std::function<void(const ExperimentResult&)>& take) {
  const Sites sites = prepare(runs);
  std::atomic<std::size_t> next{0};
  std::mutex taking;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < runs.size(); i = next++) {
      try {
        const ExperimentResult result = make(runs[i], sites.at(runs[i].of_case));
        const std::lock_guard<std::mutex> lock(taking);
        take(result);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(taking);
        if (!failure) failure = std::current_exception();
        next = runs.size();
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < jobs; ++i) threads.emplace_back(work);
  work();
  for (auto& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace adaptive_localization
