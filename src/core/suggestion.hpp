// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// "; did you mean 'laser_max_beams'?" for a misspelt name, ready to be put behind a message: the
/// known name that takes the fewest letters added, left out, changed or swapped with a neighbour
/// (optimal string alignment distance), up to a third of its letters. Empty if none is that near.
std::string suggestion(const std::string& written, const std::vector<std::string>& known);

/// The same among the keys of a map.
template <class Value>
std::string suggestion(const std::string& written, const std::map<std::string, Value>& known) {
  std::vector<std::string> names;
  for (const auto& entry : known) names.push_back(entry.first);
  return suggestion(written, names);
}

/// The keys of some options, in their order: what a misspelt one may have meant.
std::vector<std::string> keysOf(const std::vector<OptionDescription>& options);

}  // namespace adaptive_localization
