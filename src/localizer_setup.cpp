// SPDX-License-Identifier: BSD-3-Clause
// What the localizer makes of parameters.
#include <sstream>

#include "adaptive_localization/localizer.hpp"

namespace adaptive_localization {
namespace {

std::vector<OptionDescription> localizerOptions() {
  std::vector<OptionDescription> all = describe(LocalizerOptions{});
  for (const auto& rows : {describe(ScanOptions{}), describe(ConfidenceOptions{})}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace

Localizer::Setup Localizer::read(Parameters parameters) {
  const auto given = parameters.read<LocalizerOptions>();
  loadPlugins(given.plugins);
  const FilterDescription& filter = registry_.find(given.filter);
  Parameters preset;
  for (const auto& [key, value] : given.preset == "seed" ? filter.seed : filter.recommended) {
    preset.set(key, value);
  }
  parameters.fill(preset);
  Setup setup;
  setup.options = parameters.read<LocalizerOptions>();
  setup.scan = parameters.read<ScanOptions>();
  setup.confidence = parameters.read<ConfidenceOptions>();
  for (const auto& name : registry_.names()) {  // other cores' options are no mistakes
    for (const auto& option : registry_.find(name).options) parameters.acknowledge(option.key);
  }
  setup.parameters = std::move(parameters);
  return setup;
}

void Localizer::loadPlugins(const std::string& paths) {
  std::istringstream stream(paths);
  for (std::string path; std::getline(stream, path, ':');) {
    if (path.empty() || loaded_plugins_.count(path)) continue;
    registry_.loadLibrary(path);
    loaded_plugins_.insert(path);
  }
}

bool Localizer::hasSameFilter(const Setup& setup) const {
  if (setup.options.filter != setup_.options.filter || setup.options.seed != setup_.options.seed) {
    return false;
  }
  const auto& before = setup_.parameters.values();
  const auto& now = setup.parameters.values();
  for (const auto& option : registry_.find(setup.options.filter).options) {
    const auto old_value = before.find(option.key);
    const auto new_value = now.find(option.key);
    if ((old_value == before.end() ? option.value : old_value->second) !=
        (new_value == now.end() ? option.value : new_value->second)) {
      return false;
    }
  }
  return true;
}

std::vector<std::string> Localizer::unknownKeys() const {
  return setup_.parameters.unknownKeys();
}

std::vector<OptionDescription> Localizer::effectiveOptions() const {
  std::vector<OptionDescription> rows = localizerOptions();
  const auto& filter = registry_.find(setup_.options.filter).options;
  rows.insert(rows.end(), filter.begin(), filter.end());
  for (auto& row : rows) {
    const auto given = setup_.parameters.values().find(row.key);
    if (given != setup_.parameters.values().end()) row.value = given->second;
  }
  return rows;
}

std::vector<OptionDescription> Localizer::allOptions() const {
  std::vector<OptionDescription> rows = effectiveOptions();
  std::set<std::string> keys;
  for (const auto& row : rows) keys.insert(row.key);
  for (const auto& name : registry_.names()) {
    for (const auto& option : registry_.find(name).options) {
      if (!keys.insert(option.key).second) continue;
      rows.push_back(option);
      const auto given = setup_.parameters.values().find(option.key);
      if (given != setup_.parameters.values().end()) rows.back().value = given->second;
    }
  }
  for (auto& row : rows) {
    if (row.key == "filter") row.choices = registry_.names();
  }
  return rows;
}

}  // namespace adaptive_localization
