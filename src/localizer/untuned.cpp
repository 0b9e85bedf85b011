// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/untuned.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "adaptive_localization/localizer/setup.hpp"
#include "core/option_number.hpp"

namespace adaptive_localization {
namespace {

using Values = std::vector<OptionValue>;

/// amcl's defaults and its example's values; those that are as here are left out.
const std::map<std::string, Values>& usualValues() {
  static const std::map<std::string, Values> values{{"update_min_d", {0.2}},
                                                    {"update_min_a", {0.5235987755982988, 0.5}},
                                                    {"min_particles", {100}},
                                                    {"max_particles", {5000}},
                                                    {"kld_err", {0.01, 0.05}},
                                                    {"kld_z", {0.99}},
                                                    {"resample_interval", {2}},
                                                    {"selective_resampling", {false}},
                                                    {"recovery_alpha_slow", {0.0}},
                                                    {"recovery_alpha_fast", {0.0}},
                                                    {"odom_model_type", {std::string("diff")}},
                                                    {"odom_alpha1", {0.2}},
                                                    {"odom_alpha2", {0.2}},
                                                    {"odom_alpha3", {0.2, 0.8}},
                                                    {"odom_alpha4", {0.2}},
                                                    {"odom_alpha5", {0.2}},
                                                    {"laser_max_beams", {30}},
                                                    {"laser_z_hit", {0.5}},
                                                    {"laser_z_short", {0.05}},
                                                    {"laser_z_rand", {0.05, 0.5}},
                                                    {"laser_sigma_hit", {0.2}}};
  return values;
}

/// Numbers are often rounded, and whole ones may be either.
bool isSame(const OptionValue& a, const OptionValue& b) {
  constexpr double kRounding = 1e-3;
  if (!isNumber(a) || !isNumber(b)) return a == b;
  return std::abs(numberOf(a) - numberOf(b)) < kRounding;
}

}  // namespace

std::vector<std::string> untunedKeys(const Parameters& parameters) {
  std::vector<std::string> keys;
  for (const auto& [key, usual] : usualValues()) {
    const auto given = parameters.values().find(key);
    if (given == parameters.values().end()) continue;
    const bool is_usual = std::any_of(usual.begin(), usual.end(), [&](const OptionValue& value) {
      return isSame(value, given->second);
    });
    if (is_usual) keys.push_back(key);
  }
  return keys;
}

TunedParameters tuned(const Parameters& given) {
  const auto keys = untunedKeys(given);
  if (keys.empty()) return {given, ""};
  std::string names;
  for (const std::string& key : keys) names += (names.empty() ? "" : ", ") + key;
  const bool is_kept = given.read<LocalizerOptions>().amcl_compatibility == "keep";
  if (is_kept) {
    return {given,
            "These parameters have amcl's usual values, which are less accurate here than the "
            "defaults: " +
                names +
                ". Unless you tuned them, leave them out, or set "
                "amcl_compatibility: ignore_untuned"};
  }
  Parameters left;
  for (const auto& [key, value] : given.values()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) left.set(key, value);
  }
  return {left, "Ignored, as amcl_compatibility says, for they have amcl's usual values: " + names};
}

}  // namespace adaptive_localization
