// SPDX-License-Identifier: BSD-3-Clause
#include "range_kernel.hpp"

#include <algorithm>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace adaptive_localization {

constexpr int kPart = RangeTarget::kPart;
static_assert(kRangeStride % (2 * kPart) == 0, "whole parts, an even number of them");

int sumOfDistancesPortable(const std::uint8_t* low, const std::uint8_t* high,
                           const RangeTarget& target, int truncation, int most) {
  int sum = 0;
  for (std::size_t k = 0; static_cast<int>(k) < target.count && sum <= most; k += 2) {
    for (const int part : {target.parts[k], target.parts[k + 1]}) {
      for (int i = part; i < part + kPart; ++i) {
        const int distance = std::max({low[i] - target.high[i], target.low[i] - high[i], 0});
        sum += std::min(distance, truncation);
      }
    }
  }
  return sum;
}

#if defined(__x86_64__)
namespace {

__attribute__((target("avx2"))) inline __m256i load(const std::uint8_t* at) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at));
}

__attribute__((target("avx2"))) inline int total(__m256i sums) {
  const __m128i half =
      _mm_add_epi64(_mm256_castsi256_si128(sums), _mm256_extracti128_si256(sums, 1));
  return _mm_cvtsi128_si32(half) + _mm_extract_epi32(half, 2);
}

/// Sums of a part that begins at i, in four numbers.
__attribute__((target("avx2"))) inline __m256i sumsOf(int i, const std::uint8_t* low,
                                                      const std::uint8_t* high,
                                                      const RangeTarget& target, __m256i greatest) {
  // saturating differences: at most one of the two is not 0
  const __m256i above = _mm256_subs_epu8(load(low + i), load(target.high + i));
  const __m256i below = _mm256_subs_epu8(load(target.low + i), load(high + i));
  const __m256i distance = _mm256_min_epu8(_mm256_or_si256(above, below), greatest);
  return _mm256_sad_epu8(distance, _mm256_setzero_si256());
}

__attribute__((target("avx2"))) int sumOfDistancesAvx2(const std::uint8_t* low,
                                                       const std::uint8_t* high,
                                                       const RangeTarget& target, int truncation,
                                                       int most) {
  const __m256i greatest = _mm256_set1_epi8(static_cast<char>(truncation));
  int sum = 0;
  for (std::size_t k = 0; static_cast<int>(k) < target.count && sum <= most; k += 2) {
    const __m256i first = sumsOf(target.parts[k], low, high, target, greatest);
    const __m256i second = sumsOf(target.parts[k + 1], low, high, target, greatest);
    sum += total(_mm256_add_epi64(first, second));
  }
  return sum;
}

}  // namespace

RangeKernel fastestSumOfDistances() {
  return __builtin_cpu_supports("avx2") ? sumOfDistancesAvx2 : sumOfDistancesPortable;
}
#elif defined(__aarch64__)
namespace {

/// Adds to eight sums what 16 bytes tell.
inline uint16x8_t add(uint16x8_t sums, int i, const std::uint8_t* low, const std::uint8_t* high,
                      const RangeTarget& target, uint8x16_t greatest) {
  // saturating differences: at most one of the two is not 0
  const uint8x16_t above = vqsubq_u8(vld1q_u8(low + i), vld1q_u8(target.high + i));
  const uint8x16_t below = vqsubq_u8(vld1q_u8(target.low + i), vld1q_u8(high + i));
  return vpadalq_u8(sums, vminq_u8(vorrq_u8(above, below), greatest));
}

int sumOfDistancesNeon(const std::uint8_t* low, const std::uint8_t* high, const RangeTarget& target,
                       int truncation, int most) {
  const uint8x16_t greatest = vdupq_n_u8(static_cast<std::uint8_t>(truncation));
  int sum = 0;
  for (std::size_t k = 0; static_cast<int>(k) < target.count && sum <= most; k += 2) {
    uint16x8_t sums = vdupq_n_u16(0);
    for (const int part : {target.parts[k], target.parts[k + 1]}) {
      sums = add(sums, part, low, high, target, greatest);
      sums = add(sums, part + kPart / 2, low, high, target, greatest);
    }
    sum += static_cast<int>(vaddlvq_u16(sums));
  }
  return sum;
}

}  // namespace

RangeKernel fastestSumOfDistances() {
  return sumOfDistancesNeon;
}
#else
RangeKernel fastestSumOfDistances() {
  return sumOfDistancesPortable;
}
#endif

}  // namespace adaptive_localization
