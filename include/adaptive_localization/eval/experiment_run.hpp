// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/eval/experiment.hpp"
#include "adaptive_localization/eval/experiment_result.hpp"
#include "adaptive_localization/ser/ground.hpp"
#include "adaptive_localization/sim/world.hpp"

namespace adaptive_localization {

/// What all runs of a case share and none changes.
struct ExperimentSite {
  Site site;
  std::shared_ptr<const FreeSpace> free_space;  // of the simulated robot
  Ground ground;
};

/// Loads world and map. Throws std::invalid_argument naming file and reason.
ExperimentSite loadSite(const ExperimentCase& of_case);

/// Makes the core once, to find what is wrong with its parameters before hours of runs.
/// Throws std::invalid_argument naming case, core, key, value and range.
void checkCore(const ExperimentSite& site, const ExperimentCase& of_case,
               const ExperimentCore& core);

/// Drives the simulated robot through the case with the core at work, on one thread; the seed is
/// the simulation's and the core's. Same arguments, same result, but for the times of updates.
ExperimentResult runExperiment(const ExperimentSite& site, const ExperimentCase& of_case,
                               const ExperimentCore& core, int seed);

}  // namespace adaptive_localization
