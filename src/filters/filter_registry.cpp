// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/filters/filter_registry.hpp"

#include <dlfcn.h>
#include <link.h>

#include <stdexcept>

#include "adaptive_localization/core/error_text.hpp"
#include "filters/builtin_filters.hpp"

namespace adaptive_localization {
namespace {

constexpr auto kEntryPoint = "adaptive_localization_register_filters_v1";

/// A variable of that name can be looked up as well, and called, which ends the process.
bool isFunction(void* symbol) {
  Dl_info info;
  void* entry = nullptr;
  if (dladdr1(symbol, &info, &entry, RTLD_DL_SYMENT) == 0 || !entry) return false;
  return ELF64_ST_TYPE(static_cast<const ElfW(Sym)*>(entry)->st_info) == STT_FUNC;
}

}  // namespace

FilterRegistry::FilterRegistry() {
  for (auto& description : builtinFilters()) add(std::move(description));
}

void FilterRegistry::add(FilterDescription description) {
  const std::string name = description.name;
  if (name.empty() || !description.make) {
    throw std::invalid_argument("filter '" + name + "': a filter needs a name and a factory");
  }
  if (!filters_.emplace(name, std::move(description)).second) {
    throw std::invalid_argument("filter '" + name + "' is registered already");
  }
}

void FilterRegistry::loadLibrary(const std::string& path) {
  // never closed: the filters' code lives there
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::invalid_argument("plug-in '" + path + "': " + dlerror());
  void* symbol = dlsym(library, kEntryPoint);
  if (!symbol || !isFunction(symbol)) {
    throw std::invalid_argument("plug-in '" + path + "': expected a function " + kEntryPoint);
  }
  try {
    reinterpret_cast<void (*)(FilterRegistry&)>(symbol)(*this);
  } catch (...) {
    throw std::invalid_argument("plug-in '" + path + "': " + errorText());
  }
}

const FilterDescription& FilterRegistry::find(const std::string& name) const {
  const auto found = filters_.find(name);
  if (found != filters_.end()) return found->second;
  std::string known;
  for (const auto& other : names()) known += (known.empty() ? "" : ", ") + other;
  throw std::invalid_argument("option 'filter': got '" + name + "', expected one of " + known);
}

std::vector<std::string> FilterRegistry::names() const {
  std::vector<std::string> names;
  for (const auto& entry : filters_) names.push_back(entry.first);
  return names;
}

}  // namespace adaptive_localization
