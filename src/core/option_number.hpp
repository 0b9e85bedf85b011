// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

inline bool isNumber(const OptionValue& value) {
  return std::holds_alternative<int>(value) || std::holds_alternative<double>(value);
}

/// Of a number, whole or not.
inline double numberOf(const OptionValue& value) {
  const auto* whole = std::get_if<int>(&value);
  return whole ? *whole : std::get<double>(value);
}

}  // namespace adaptive_localization
