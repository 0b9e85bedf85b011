// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "eval/experiment.hpp"
#include "yaml_value.hpp"

namespace adaptive_localization {

/// A hash of what a case says, its world and its map with image, but for labels, cores and seeds.
std::string fingerprint(const YamlValue& value, const ExperimentCase& of_case);

/// A hash of a core's options, with the contents of the files that they name.
std::string fingerprint(const Parameters& parameters);

/// A hash of a text, 16 hexadecimal digits (FNV-1a).
std::string hashOf(const std::string& text);

}  // namespace adaptive_localization
