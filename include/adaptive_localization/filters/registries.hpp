// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/core/registry.hpp"
#include "adaptive_localization/filters/filter.hpp"

namespace adaptive_localization {

/// A filter core as it is registered. A preset holds the values that differ from the options' own
/// defaults; what the user gives overrides it.
struct FilterDescription {
  std::string name;
  std::string sentence;
  std::function<std::unique_ptr<Filter>(const FilterContext&)> make;
  std::vector<OptionDescription> options;  // all that make() reads but the options of models
  std::map<std::string, OptionValue> recommended;
  std::map<std::string, OptionValue> seed;  // the literature's form, for comparison
  std::map<std::string, std::map<std::string, OptionValue>> more_presets{};  // of other works

  /// "recommended", "seed" and the further ones.
  std::vector<std::string> presetNames() const;
  /// Throws std::invalid_argument naming the option, the name and those that this core has.
  const std::map<std::string, OptionValue>& preset(const std::string& of) const;
};

/// All that is chosen by name.
struct Registries : Models {
  Registry<FilterDescription> filters{"filter"};

  /// Loads a shared library and lets it add what it brings. The library defines
  ///
  ///     extern "C" void adaptive_localization_register_v2(Registries& registries);
  ///
  /// and stays loaded until the process ends. Throws std::invalid_argument naming the library and
  /// what is wrong with it; nothing is added then.
  void loadLibrary(const std::string& path);
};

/// A filter's options and, after one that chooses a model, those of all such models, whichever is
/// chosen: the names of these are that option's choices. At last those of the senses.
std::vector<OptionDescription> optionsOf(const FilterDescription& filter, const Models& models);

/// The same of all filters; each key once.
std::vector<OptionDescription> optionsOfAll(const Registries& registries);

}  // namespace adaptive_localization
