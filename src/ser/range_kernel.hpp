// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "ser/scan_energy.hpp"

namespace adaptive_localization {

/// What rows of ranges are compared with: an interval for each range, and the parts of a row that
/// tell anything; in the others each interval is [0, 255].
struct RangeTarget {
  static constexpr int kPart = 32;  // bytes
  static constexpr int kParts = static_cast<int>(kRangeStride) / kPart;

  const std::uint8_t* low{nullptr};
  const std::uint8_t* high{nullptr};
  std::array<int, kParts> parts{};  // their first bytes
  int count{0};                     // even
};

/// Sum over a target's parts of the distance between its intervals and [low, high], at `truncation`
/// at the most each. An interval [0, 255] is at no distance from any other. Where the sum is
/// greater than `most`, which most of them are, what is returned is greater than that, too, and the
/// rest is not looked at.
using RangeKernel = int (*)(const std::uint8_t* low, const std::uint8_t* high,
                            const RangeTarget& target, int truncation, int most);

int sumOfDistancesPortable(const std::uint8_t* low, const std::uint8_t* high,
                           const RangeTarget& target, int truncation, int most);

/// The same in AVX2 or NEON where the processor has it, else sumOfDistancesPortable.
RangeKernel fastestSumOfDistances();

}  // namespace adaptive_localization
