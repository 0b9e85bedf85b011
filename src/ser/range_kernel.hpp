// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace adaptive_localization {

/// Sum over 192 bytes of the distance between the intervals [a_low, a_high] and [b_low, b_high], at
/// most `truncation` each. An interval [0, 255] is at no distance from any other.
using RangeKernel = int (*)(const std::uint8_t* a_low, const std::uint8_t* a_high,
                            const std::uint8_t* b_low, const std::uint8_t* b_high, int truncation);

int sumOfDistancesPortable(const std::uint8_t* a_low, const std::uint8_t* a_high,
                           const std::uint8_t* b_low, const std::uint8_t* b_high, int truncation);

/// The same in AVX2 where the processor has it, else sumOfDistancesPortable.
RangeKernel fastestSumOfDistances();

}  // namespace adaptive_localization
