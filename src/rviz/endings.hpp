// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace adaptive_localization {

inline bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() &&
         text.compare(text.size() - end.size(), std::string::npos, end) == 0;
}

}  // namespace adaptive_localization
