// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/former_options.hpp"

#include <map>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

/// Old names, and what was expected instead.
const std::map<std::string, std::string>& formerOptions() {
  static const std::map<std::string, std::string> table{
      {"bat_leap_size", "nothing: it is always 0.1"},
      {"bat_loudness_decay", "nothing: it is always 0.9"},
      {"bat_pulse_growth", "nothing: it is always 0.9"},
      {"ekf_cloud", "'cloud_particles'"},
      {"ekf_gate", "'ekf_gate_probability', 0.99 for 11.34"},
      {"line_gate", "nothing: 99 % of the right lines are within it"},
      {"line_lead", "nothing: it is always 4"},
      {"line_least_inliers", "nothing: it is always 0.2"},
      {"line_split", "nothing: it is always 4"},
      {"markov_cloud", "'cloud_particles'"},
      {"match_keep", "nothing: the share is found for each scan"},
      {"place_deviation_theta", "nothing: it is always 0.0524 rad"},
      {"place_deviation_xy", "nothing: it is always 0.1 m"},
      {"place_error_scale", "nothing: it is always 0.02 m"},
      {"swarm_truncation", "nothing: it is always 0.25 m"}};
  return table;
}

}  // namespace

void refuseFormerOptions(const Parameters& parameters) {
  for (const auto& [key, value] : parameters.values()) {
    const auto former = formerOptions().find(key);
    if (former == formerOptions().end()) continue;
    throw std::invalid_argument("option '" + key + "': got " + toText(value) +
                                ", but it is no more; expected " + former->second);
  }
}

}  // namespace adaptive_localization
