// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace adaptive_localization {

/// Sum over 192 bytes of the distance between the intervals [a_low, a_high] and [b_low, b_high], at
/// `truncation` at the most each. An interval [0, 255] is at no distance from any other. Where the
/// sum is greater than `most`, which most of them are, what is returned is greater than that, too,
/// and the rest is not looked at.
using RangeKernel = int (*)(const std::uint8_t* a_low, const std::uint8_t* a_high,
                            const std::uint8_t* b_low, const std::uint8_t* b_high, int truncation,
                            int most);

int sumOfDistancesPortable(const std::uint8_t* a_low, const std::uint8_t* a_high,
                           const std::uint8_t* b_low, const std::uint8_t* b_high, int truncation,
                           int most);

/// The same in AVX2 or NEON where the processor has it, else sumOfDistancesPortable.
RangeKernel fastestSumOfDistances();

}  // namespace adaptive_localization
