// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/filters/filter.hpp"

namespace adaptive_localization {

using FilterFactory = std::function<std::unique_ptr<Filter>(const FilterContext&)>;

/// A filter core as it is registered. A preset holds the values that differ from the options' own
/// defaults; what the user gives overrides it.
struct FilterDescription {
  std::string name;
  std::string sentence;
  FilterFactory make;
  std::vector<OptionDescription> options;  // all that make() reads
  std::map<std::string, OptionValue> recommended;
  std::map<std::string, OptionValue> seed;  // the literature's form, for comparison
};

/// Filter cores by name. Starts with the built-in ones; someone else's come from their library.
class FilterRegistry {
 public:
  FilterRegistry();

  /// Throws std::invalid_argument if the name is taken.
  void add(FilterDescription description);

  /// Loads a shared library and lets it add its filters. The library defines
  ///
  ///     extern "C" void adaptive_localization_register_filters_v1(FilterRegistry& registry);
  ///
  /// and stays loaded until the process ends. Throws std::invalid_argument naming the library and
  /// what is wrong with it.
  void loadLibrary(const std::string& path);

  /// Throws std::invalid_argument listing the known names.
  const FilterDescription& find(const std::string& name) const;

  std::vector<std::string> names() const;

 private:
  std::map<std::string, FilterDescription> filters_;
};

}  // namespace adaptive_localization
