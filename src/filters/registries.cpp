// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/filters/registries.hpp"

#include <dlfcn.h>
#include <link.h>

#include <set>
#include <stdexcept>

#include "core/error_text.hpp"

namespace adaptive_localization {
namespace {

constexpr auto kEntryPoint = "adaptive_localization_register_v2";
constexpr auto kOldEntryPoint = "adaptive_localization_register_filters_v1";

/// A variable of that name can be looked up as well, and called, which ends the process.
bool isFunction(void* symbol) {
  Dl_info info;
  void* entry = nullptr;
  if (dladdr1(symbol, &info, &entry, RTLD_DL_SYMENT) == 0 || !entry) return false;
  return ELF64_ST_TYPE(static_cast<const ElfW(Sym)*>(entry)->st_info) == STT_FUNC;
}

std::string missingIn(void* library) {
  const std::string expected = std::string("expected a function ") + kEntryPoint;
  if (!dlsym(library, kOldEntryPoint)) return expected;
  return expected + ", got " + kOldEntryPoint + ": it was written for an older version";
}

/// Rows of options in which no key is twice.
class Rows {
 public:
  bool add(const OptionDescription& option) {
    if (!keys_.insert(option.key).second) return false;
    rows_.push_back(option);
    return true;
  }

  /// What the last row, if it is the one that chooses among these, can choose.
  template <class Description>
  void addModels(const Registry<Description>& known) {
    if (rows_.back().key != known.key()) return;
    rows_.back().choices = known.names();
    for (const auto& name : known.names()) {
      for (const auto& option : known.find(name).options) add(option);
    }
  }

  std::vector<OptionDescription> take() { return std::move(rows_); }

 private:
  std::set<std::string> keys_;
  std::vector<OptionDescription> rows_;
};

}  // namespace

std::vector<std::string> FilterDescription::presetNames() const {
  std::vector<std::string> names{"recommended", "seed"};
  for (const auto& more : more_presets) names.push_back(more.first);
  return names;
}

const std::map<std::string, OptionValue>& FilterDescription::preset(const std::string& of) const {
  if (of == "recommended") return recommended;
  if (of == "seed") return seed;
  const auto found = more_presets.find(of);
  if (found != more_presets.end()) return found->second;
  std::string known;
  for (const auto& each : presetNames()) known += (known.empty() ? "" : ", ") + each;
  throw std::invalid_argument("option 'preset': got '" + of + "', expected one of " + known +
                              ": those of " + name);
}

void Registries::loadLibrary(const std::string& path) {
  // never closed: the code of what it adds lives there
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::invalid_argument("plug-in '" + path + "': " + dlerror());
  void* symbol = dlsym(library, kEntryPoint);
  if (!symbol || !isFunction(symbol)) {
    throw std::invalid_argument("plug-in '" + path + "': " + missingIn(library));
  }
  Registries extended = *this;
  try {
    reinterpret_cast<void (*)(Registries&)>(symbol)(extended);
  } catch (...) {
    throw std::invalid_argument("plug-in '" + path + "': " + errorText());
  }
  *this = std::move(extended);
}

std::vector<OptionDescription> optionsOf(const FilterDescription& filter, const Models& models) {
  Rows rows;
  for (const auto& option : filter.options) {
    if (!rows.add(option)) continue;
    rows.addModels(models.motions);
    rows.addModels(models.observations);
    rows.addModels(models.resamplings);
  }
  for (const auto& name : models.senses.names()) {
    for (const auto& option : models.senses.find(name).options) rows.add(option);
  }
  return rows.take();
}

std::vector<OptionDescription> optionsOfAll(const Registries& registries) {
  Rows rows;
  for (const auto& name : registries.filters.names()) {
    for (const auto& option : optionsOf(registries.filters.find(name), registries)) {
      rows.add(option);
    }
  }
  return rows.take();
}

}  // namespace adaptive_localization
