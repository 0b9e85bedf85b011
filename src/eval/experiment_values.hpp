// SPDX-License-Identifier: BSD-3-Clause
// The parts of an experiment's file.
#pragma once

#include <array>

#include "eval/experiment.hpp"
#include "yaml_value.hpp"

namespace adaptive_localization {

/// Options of cores that name a file, a map of their own.
constexpr std::array<const char*, 2> kMapOptions{"line_map", "landmark_map"};

void readWorld(const YamlValue& value, ExperimentCase& result);

/// Start and what is told of it, route, robot and duration.
void readDrive(const YamlValue& value, ExperimentCase& result);

Spot readSpot(const YamlValue& value);
ExperimentEvent readEvent(const YamlValue& value);
SuccessRule readSuccess(const YamlValue& value);
ExperimentCore readCore(const YamlValue& value);

/// Options of cores. A file that one names is looked for from the place of the experiment's;
/// "world" stays as it is.
Parameters readOptions(const YamlValue& value);

}  // namespace adaptive_localization
