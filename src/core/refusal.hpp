// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace adaptive_localization {

/// Throws std::invalid_argument that names a thing, its value and what was expected.
[[noreturn]] inline void reject(const std::string& what, double value,
                                const std::string& expected) {
  std::ostringstream text;
  text << what << ": got " << value << ", expected " << expected;
  throw std::invalid_argument(text.str());
}

}  // namespace adaptive_localization
