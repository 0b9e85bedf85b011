// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/filters/builtins.hpp"

#include "builtin_filters.hpp"

namespace adaptive_localization {
namespace {

Registries makeBuiltins() {
  Registries registries;
  for (auto& description : builtinFilters()) registries.filters.add(std::move(description));
  return registries;
}

}  // namespace

const Registries& builtins() {
  static const Registries all = makeBuiltins();
  return all;
}

}  // namespace adaptive_localization
