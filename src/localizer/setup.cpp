// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/setup.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "localizer/former_options.hpp"
#include "match/scan_matcher.hpp"
#include "observation/landmark_model.hpp"
#include "particle/sample_size.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {
namespace {

std::vector<OptionDescription> placesOptions() {
  std::vector<OptionDescription> all = describe(EnergyGridOptions{});
  const auto search = describe(GlobalSearchOptions{});
  all.insert(all.end(), search.begin(), search.end());
  return all;
}

std::vector<OptionDescription> localizerOptions() {
  std::vector<OptionDescription> all = describe(LocalizerOptions{});
  for (const auto& rows : {describe(ScanOptions{}), describe(ConfidenceOptions{}),
                           describe(CompassOptions{}), describe(MatchOptions{}), placesOptions()}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

/// A given value as the type that the option has: 1 may stand for 1.0 or true.
OptionValue asTypeOf(const OptionValue& option, const OptionValue& given) {
  if (std::holds_alternative<std::string>(option)) return toText(given);
  const auto* whole = std::get_if<int>(&given);
  if (whole && std::holds_alternative<double>(option)) return static_cast<double>(*whole);
  if (whole && std::holds_alternative<bool>(option)) return *whole != 0;
  const auto* real = std::get_if<double>(&given);
  if (real && std::holds_alternative<int>(option) && std::abs(*real) < 1e9) {
    return static_cast<int>(*real);
  }
  return given;
}

OptionValue valueOf(const OptionDescription& option, const Parameters& parameters) {
  const auto given = parameters.values().find(option.key);
  return given == parameters.values().end() ? option.value : asTypeOf(option.value, given->second);
}

bool areEqual(const std::vector<OptionDescription>& options, const Parameters& a,
              const Parameters& b) {
  return std::all_of(options.begin(), options.end(), [&](const OptionDescription& option) {
    return valueOf(option, a) == valueOf(option, b);
  });
}

void check(const ScanOptions& scan) {
  if (scan.laser_max_range <= 0.0 || scan.laser_min_range < scan.laser_max_range) return;
  throw std::invalid_argument("option 'laser_min_range': got '" + toText(scan.laser_min_range) +
                              "', expected less than laser_max_range, which is '" +
                              toText(scan.laser_max_range) + "'");
}

/// Reflectors are looked for among the landmarks.
void check(const ScanOptions& scan, const LandmarkOptions& landmarks) {
  if (scan.reflector_intensity <= 0.0 || !landmarks.landmark_map.empty()) return;
  throw std::invalid_argument("option 'reflector_intensity': got '" +
                              toText(scan.reflector_intensity) +
                              "' without a landmark_map, expected both");
}

}  // namespace

Setup SetupReader::read(Parameters parameters) {
  refuseFormerOptions(parameters);
  const auto given = parameters.read<LocalizerOptions>();
  loadPlugins(given.plugins);
  const FilterDescription& filter = registries_.filters.find(given.filter);
  Parameters preset;
  for (const auto& [key, value] : filter.preset(given.preset)) {
    preset.set(key, value);
  }
  const Parameters by_user = parameters;
  parameters.fill(preset);
  orderLimits(by_user, parameters);
  Setup setup;
  setup.options = parameters.read<LocalizerOptions>();
  setup.scan = parameters.read<ScanOptions>();
  check(setup.scan);
  check(setup.scan, parameters.read<LandmarkOptions>());
  setup.confidence = parameters.read<ConfidenceOptions>();
  setup.compass = parameters.read<CompassOptions>();
  parameters.read<MatchOptions>();                        // they are known, whoever needs them
  for (const auto& option : optionsOfAll(registries_)) {  // other cores' options are no mistakes
    parameters.acknowledge(option.key);
  }
  setup.parameters = std::move(parameters);
  return setup;
}

void SetupReader::loadPlugins(const std::string& paths) {
  std::istringstream stream(paths);
  for (std::string path; std::getline(stream, path, ':');) {
    if (path.empty() || loaded_plugins_.count(path)) continue;
    registries_.loadLibrary(path);
    loaded_plugins_.insert(path);
  }
}

bool SetupReader::haveSameFilter(const Setup& a, const Setup& b) const {
  if (a.options.filter != b.options.filter || a.options.seed != b.options.seed) return false;
  const FilterDescription& filter = registries_.filters.find(a.options.filter);
  return areEqual(optionsOf(filter, registries_), a.parameters, b.parameters);
}

bool SetupReader::haveSamePlaces(const Setup& a, const Setup& b) const {
  return areEqual(placesOptions(), a.parameters, b.parameters);
}

bool SetupReader::haveSameMatcher(const Setup& a, const Setup& b) const {
  return a.options.refine == b.options.refine &&
         areEqual(describe(MatchOptions{}), a.parameters, b.parameters);
}

std::vector<OptionDescription> SetupReader::effectiveOptions(const Setup& setup) const {
  std::vector<OptionDescription> rows = localizerOptions();
  const auto filter = optionsOf(registries_.filters.find(setup.options.filter), registries_);
  rows.insert(rows.end(), filter.begin(), filter.end());
  for (auto& row : rows) row.value = valueOf(row, setup.parameters);
  return rows;
}

std::vector<OptionDescription> SetupReader::allOptions(const Setup& setup) const {
  std::vector<OptionDescription> rows = effectiveOptions(setup);
  std::set<std::string> keys;
  for (const auto& row : rows) keys.insert(row.key);
  for (const auto& option : optionsOfAll(registries_)) {
    if (!keys.insert(option.key).second) continue;
    rows.push_back(option);
    rows.back().value = valueOf(option, setup.parameters);
  }
  for (auto& row : rows) {
    if (row.key == "filter") row.choices = registries_.filters.names();
  }
  return rows;
}

}  // namespace adaptive_localization
