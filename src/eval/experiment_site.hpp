// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/ser/ground.hpp"
#include "eval/experiment.hpp"
#include "sim/world.hpp"

namespace adaptive_localization {

/// What all runs of a case share and none changes.
struct ExperimentSite {
  Site site;
  std::shared_ptr<const FreeSpace> free_space;  // of the simulated robot
  Ground ground;
};

/// Loads world and map. Throws std::invalid_argument naming file and reason.
ExperimentSite loadSite(const ExperimentCase& of_case);

}  // namespace adaptive_localization
