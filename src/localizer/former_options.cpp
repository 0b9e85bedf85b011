// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/former_options.hpp"

#include <map>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

/// Removed options, and what does their work now.
const std::map<std::string, std::string>& formerOptions() {
  static const std::map<std::string, std::string> table{
      {"bat_leap_size", "it is always 0.1"},
      {"bat_loudness_decay", "it is always 0.9"},
      {"bat_pulse_growth", "it is always 0.9"},
      {"ekf_cloud", "it is 'cloud_particles' now"},
      {"ekf_gate", "it is 'ekf_gate_probability' now, 0.99 for 11.34"},
      {"evidence_free", "it is always 0.35"},
      {"evidence_occupied", "it is always 0.65"},
      {"line_gate", "99 % of the right lines pass its gate"},
      {"line_lead", "it is always 4"},
      {"line_least_inliers", "it is always 0.2"},
      {"line_split", "it is always 4"},
      {"markov_cloud", "it is 'cloud_particles' now"},
      {"match_keep", "the share is found for each scan"},
      {"place_deviation_theta", "it is always 0.0524 rad"},
      {"place_deviation_xy", "it is always 0.1 m"},
      {"place_error_scale", "it is always 0.02 m"},
      {"swarm_truncation", "it is always 0.25 m"}};
  return table;
}

}  // namespace

void refuseFormerOptions(const Parameters& parameters) {
  for (const auto& [key, value] : parameters.values()) {
    const auto former = formerOptions().find(key);
    if (former == formerOptions().end()) continue;
    throw std::invalid_argument("option '" + key + "': got " + toText(value) +
                                ", but this option was removed: " + former->second);
  }
}

}  // namespace adaptive_localization
