// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <vector>

namespace adaptive_localization {

/// Any double, infinite ones and none included, or one of those that are usual.
inline double anyNumber(FuzzedDataProvider& given) {
  return given.ConsumeBool() ? given.ConsumeFloatingPoint<double>()
                             : given.ConsumeFloatingPointInRange(-10.0, 10.0);
}

/// So many at the most, of any bits.
template <class Number>
std::vector<Number> anyNumbers(FuzzedDataProvider& given, std::size_t most) {
  std::vector<Number> all(given.ConsumeIntegralInRange<std::size_t>(0, most));
  if (!all.empty()) given.ConsumeData(all.data(), all.size() * sizeof(Number));
  return all;
}

}  // namespace adaptive_localization
