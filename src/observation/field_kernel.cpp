// SPDX-License-Identifier: BSD-3-Clause
#include "field_kernel.hpp"

#include <cstddef>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace adaptive_localization {

void sumPortable(const FieldView& field, const PoseColumns& poses, std::size_t begin,
                 std::size_t end, const float* x, const float* y, int hits, std::int32_t* sums) {
  for (std::size_t i = begin; i < end; ++i) {
    const float u = poses.u[i];
    const float v = poses.v[i];
    const float c = poses.cos[i];
    const float s = poses.sin[i];
    std::int32_t sum = 0;
    for (int j = 0; j < hits; ++j) {
      sum += valueAt(field, u + (c * x[j] - s * y[j]), v + (s * x[j] + c * y[j]));
    }
    sums[i] = sum;
  }
}

#if defined(__x86_64__)
namespace {

constexpr std::size_t kLanes = 8;
constexpr int kTileRowsLog2 = 5;
static_assert(1 << kTileRowsLog2 == SparseGrid::kTileRows);

__attribute__((target("avx2"))) void sumAvx2(const FieldView& field, const PoseColumns& poses,
                                             std::size_t begin, std::size_t end, const float* x,
                                             const float* y, int hits, std::int32_t* sums) {
  const __m256 zero = _mm256_setzero_ps();
  const __m256 max_u = _mm256_set1_ps(field.max_u);
  const __m256 max_v = _mm256_set1_ps(field.max_v);
  const __m256i stride = _mm256_set1_epi32(field.stride);
  const __m256i in_tile_mask = _mm256_set1_epi32(SparseGrid::kTileRows - 1);
  const __m256i low_half = _mm256_set1_epi32(0xFFFF);
  const auto* values = reinterpret_cast<const int*>(field.values);
  std::size_t i = begin;
  for (; i + kLanes <= end; i += kLanes) {
    const __m256 u = _mm256_loadu_ps(poses.u + i);
    const __m256 v = _mm256_loadu_ps(poses.v + i);
    const __m256 c = _mm256_loadu_ps(poses.cos + i);
    const __m256 s = _mm256_loadu_ps(poses.sin + i);
    __m256i sum = _mm256_setzero_si256();
    for (int j = 0; j < hits; ++j) {
      const __m256 hx = _mm256_broadcast_ss(x + j);
      const __m256 hy = _mm256_broadcast_ss(y + j);
      const __m256 du = _mm256_sub_ps(_mm256_mul_ps(c, hx), _mm256_mul_ps(s, hy));
      const __m256 dv = _mm256_add_ps(_mm256_mul_ps(s, hx), _mm256_mul_ps(c, hy));
      // max(a, 0) is 0 for a NaN, as in valueAt
      const __m256 column = _mm256_min_ps(_mm256_max_ps(_mm256_add_ps(u, du), zero), max_u);
      const __m256 row = _mm256_min_ps(_mm256_max_ps(_mm256_add_ps(v, dv), zero), max_v);
      const __m256i row_of = _mm256_cvttps_epi32(row);
      const __m256i in_tile = _mm256_and_si256(row_of, in_tile_mask);
      const __m256i strip = _mm256_mullo_epi32(_mm256_sub_epi32(row_of, in_tile), stride);
      const __m256i x_in_strip = _mm256_slli_epi32(_mm256_cvttps_epi32(column), kTileRowsLog2);
      const __m256i index = _mm256_add_epi32(_mm256_add_epi32(strip, x_in_strip), in_tile);
      sum = _mm256_add_epi32(sum,
                             _mm256_and_si256(_mm256_i32gather_epi32(values, index, 2), low_half));
    }
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums + i), sum);
  }
  sumPortable(field, poses, i, end, x, y, hits, sums);
}

}  // namespace

SumKernel fastestSum() {
  return __builtin_cpu_supports("avx2") ? sumAvx2 : sumPortable;
}
#else
SumKernel fastestSum() {
  return sumPortable;
}
#endif

}  // namespace adaptive_localization
