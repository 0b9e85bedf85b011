// SPDX-License-Identifier: BSD-3-Clause
#include "range_kernel.hpp"

#include <algorithm>

#include "adaptive_localization/ser/range_table.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace adaptive_localization {

constexpr int kBytes = static_cast<int>(kRangeStride);

int sumOfDistancesPortable(const std::uint8_t* a_low, const std::uint8_t* a_high,
                           const std::uint8_t* b_low, const std::uint8_t* b_high, int truncation) {
  int sum = 0;
  for (int i = 0; i < kBytes; ++i) {
    const int distance = std::max({a_low[i] - b_high[i], b_low[i] - a_high[i], 0});
    sum += std::min(distance, truncation);
  }
  return sum;
}

#if defined(__x86_64__)
namespace {

static_assert(kRangeStride % 32 == 0, "whole vectors");

__attribute__((target("avx2"))) inline __m256i load(const std::uint8_t* at) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at));
}

__attribute__((target("avx2"))) int sumOfDistancesAvx2(const std::uint8_t* a_low,
                                                       const std::uint8_t* a_high,
                                                       const std::uint8_t* b_low,
                                                       const std::uint8_t* b_high, int truncation) {
  const __m256i most = _mm256_set1_epi8(static_cast<char>(truncation));
  __m256i sum = _mm256_setzero_si256();
  for (int i = 0; i < kBytes; i += 32) {
    // saturating differences: at most one of the two is not 0
    const __m256i above = _mm256_subs_epu8(load(a_low + i), load(b_high + i));
    const __m256i below = _mm256_subs_epu8(load(b_low + i), load(a_high + i));
    const __m256i distance = _mm256_min_epu8(_mm256_or_si256(above, below), most);
    sum = _mm256_add_epi64(sum, _mm256_sad_epu8(distance, _mm256_setzero_si256()));
  }
  const __m128i half = _mm_add_epi64(_mm256_castsi256_si128(sum), _mm256_extracti128_si256(sum, 1));
  return _mm_cvtsi128_si32(half) + _mm_extract_epi32(half, 2);
}

}  // namespace

RangeKernel fastestSumOfDistances() {
  return __builtin_cpu_supports("avx2") ? sumOfDistancesAvx2 : sumOfDistancesPortable;
}
#else
RangeKernel fastestSumOfDistances() {
  return sumOfDistancesPortable;
}
#endif

}  // namespace adaptive_localization
