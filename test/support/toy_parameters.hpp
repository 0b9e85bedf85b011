// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

using Values = std::map<std::string, OptionValue>;

/// Those of a small plain filter, whatever the defaults are, and some more.
inline Parameters parametersWith(const Values& more = {}) {
  Parameters parameters;
  const Values values{{"filter", std::string("mcl")}, {"max_particles", 1000},
                      {"update_min_d", 0.2},          {"update_min_a", 0.2},
                      {"laser_sigma_hit", 0.1},       {"effective_beams", 12.0}};
  for (const auto& [key, value] : values) parameters.set(key, value);
  for (const auto& [key, value] : more) parameters.set(key, value);
  return parameters;
}

/// An options struct's values.
template <class Options>
Parameters parametersOf(const Options& options) {
  Parameters parameters;
  for (const auto& row : describe(options)) parameters.set(row.key, row.value);
  return parameters;
}

}  // namespace adaptive_localization
