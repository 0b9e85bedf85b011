// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/filters/registries.hpp"

#include <dlfcn.h>
#include <link.h>

#include <stdexcept>

#include "adaptive_localization/core/error_text.hpp"

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

}  // namespace

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

}  // namespace adaptive_localization
