// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/experiment.hpp"
#include "eval/experiment_result.hpp"
#include "eval/experiment_site.hpp"

namespace adaptive_localization {

/// Makes the core once, to find what is wrong with its parameters before hours of runs.
/// Throws std::invalid_argument naming case, core, key, value and range.
void checkCore(const ExperimentSite& site, const ExperimentCase& of_case,
               const ExperimentCore& core);

/// Drives the simulated robot through the case with the core at work, on one thread; the seed is
/// the simulation's and the core's. Same arguments, same result, but for the times of updates.
ExperimentResult runExperiment(const ExperimentSite& site, const ExperimentCase& of_case,
                               const ExperimentCore& core, int seed);

}  // namespace adaptive_localization
