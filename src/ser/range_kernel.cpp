// SPDX-License-Identifier: BSD-3-Clause
#include "range_kernel.hpp"

#include <algorithm>

#include "ser/range_table.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace adaptive_localization {

constexpr int kBytes = static_cast<int>(kRangeStride);
constexpr int kLine = 64;  // of the cache
static_assert(kBytes % kLine == 0, "whole lines");

int sumOfDistancesPortable(const std::uint8_t* a_low, const std::uint8_t* a_high,
                           const std::uint8_t* b_low, const std::uint8_t* b_high, int truncation,
                           int most) {
  int sum = 0;
  for (int line = 0; line < kBytes && sum <= most; line += kLine) {
    for (int i = line; i < line + kLine; ++i) {
      const int distance = std::max({a_low[i] - b_high[i], b_low[i] - a_high[i], 0});
      sum += std::min(distance, truncation);
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

__attribute__((target("avx2"))) int sumOfDistancesAvx2(const std::uint8_t* a_low,
                                                       const std::uint8_t* a_high,
                                                       const std::uint8_t* b_low,
                                                       const std::uint8_t* b_high, int truncation,
                                                       int most) {
  const __m256i greatest = _mm256_set1_epi8(static_cast<char>(truncation));
  int sum = 0;
  for (int line = 0; line < kBytes && sum <= most; line += kLine) {
    __m256i sums = _mm256_setzero_si256();
    for (int i = line; i < line + kLine; i += 32) {
      // saturating differences: at most one of the two is not 0
      const __m256i above = _mm256_subs_epu8(load(a_low + i), load(b_high + i));
      const __m256i below = _mm256_subs_epu8(load(b_low + i), load(a_high + i));
      const __m256i distance = _mm256_min_epu8(_mm256_or_si256(above, below), greatest);
      sums = _mm256_add_epi64(sums, _mm256_sad_epu8(distance, _mm256_setzero_si256()));
    }
    sum += total(sums);
  }
  return sum;
}

}  // namespace

RangeKernel fastestSumOfDistances() {
  return __builtin_cpu_supports("avx2") ? sumOfDistancesAvx2 : sumOfDistancesPortable;
}
#elif defined(__aarch64__)
namespace {

int sumOfDistancesNeon(const std::uint8_t* a_low, const std::uint8_t* a_high,
                       const std::uint8_t* b_low, const std::uint8_t* b_high, int truncation,
                       int most) {
  const uint8x16_t greatest = vdupq_n_u8(static_cast<std::uint8_t>(truncation));
  int sum = 0;
  for (int line = 0; line < kBytes && sum <= most; line += kLine) {
    uint16x8_t sums = vdupq_n_u16(0);
    for (int i = line; i < line + kLine; i += 16) {
      // saturating differences: at most one of the two is not 0
      const uint8x16_t above = vqsubq_u8(vld1q_u8(a_low + i), vld1q_u8(b_high + i));
      const uint8x16_t below = vqsubq_u8(vld1q_u8(b_low + i), vld1q_u8(a_high + i));
      sums = vpadalq_u8(sums, vminq_u8(vorrq_u8(above, below), greatest));
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
