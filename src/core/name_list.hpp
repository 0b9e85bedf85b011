// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace adaptive_localization {

/// The names in a list separated by spaces or commas, each once.
inline std::vector<std::string> namesIn(std::string list) {
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream words(list);
  std::vector<std::string> names;
  for (std::string name; words >> name;) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace adaptive_localization
