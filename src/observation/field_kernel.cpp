// SPDX-License-Identifier: BSD-3-Clause
#include "field_kernel.hpp"

#include <cstddef>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
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

namespace {

[[maybe_unused]] constexpr int kTileRowsLog2 = 5;
static_assert(1 << kTileRowsLog2 == SparseGrid::kTileRows);

}  // namespace

#if defined(__x86_64__)
namespace {

constexpr std::size_t kLanes = 8;

/// One by one: many processors take longer for a gather.
__attribute__((target("avx2"))) inline __m256i looked(const std::uint16_t* values, __m256i index) {
  const __m128i low = _mm256_castsi256_si128(index), high = _mm256_extracti128_si256(index, 1);
  const auto at = [values](std::int64_t pair, int shift) {
    return values[static_cast<std::uint32_t>(static_cast<std::uint64_t>(pair) >> shift)];
  };
  const std::int64_t a = _mm_cvtsi128_si64(low), b = _mm_extract_epi64(low, 1);
  const std::int64_t c = _mm_cvtsi128_si64(high), d = _mm_extract_epi64(high, 1);
  __m128i value = _mm_cvtsi32_si128(at(a, 0));
  value = _mm_insert_epi16(value, at(a, 32), 1);
  value = _mm_insert_epi16(value, at(b, 0), 2);
  value = _mm_insert_epi16(value, at(b, 32), 3);
  value = _mm_insert_epi16(value, at(c, 0), 4);
  value = _mm_insert_epi16(value, at(c, 32), 5);
  value = _mm_insert_epi16(value, at(d, 0), 6);
  value = _mm_insert_epi16(value, at(d, 32), 7);
  return _mm256_cvtepu16_epi32(value);
}

__attribute__((target("avx2"))) void sumAvx2(const FieldView& field, const PoseColumns& poses,
                                             std::size_t begin, std::size_t end, const float* x,
                                             const float* y, int hits, std::int32_t* sums) {
  const __m256 zero = _mm256_setzero_ps();
  const __m256 max_u = _mm256_set1_ps(field.max_u);
  const __m256 max_v = _mm256_set1_ps(field.max_v);
  const __m256i stride = _mm256_set1_epi32(field.stride);
  const __m256i in_tile_mask = _mm256_set1_epi32(SparseGrid::kTileRows - 1);
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
      const __m256i value = looked(field.values, index);
      sum = _mm256_add_epi32(sum, field.list ? looked(field.list, value) : value);
    }
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums + i), sum);
  }
  sumPortable(field, poses, i, end, x, y, hits, sums);
}

}  // namespace

SumKernel fastestSum() {
  return __builtin_cpu_supports("avx2") ? sumAvx2 : sumPortable;
}
#elif defined(__aarch64__)
namespace {

constexpr std::size_t kLanes = 4;

/// There is no gather.
inline int32x4_t looked(const std::uint16_t* values, int32x4_t index) {
  int32x4_t value = vdupq_n_s32(values[vgetq_lane_s32(index, 0)]);
  value = vsetq_lane_s32(values[vgetq_lane_s32(index, 1)], value, 1);
  value = vsetq_lane_s32(values[vgetq_lane_s32(index, 2)], value, 2);
  return vsetq_lane_s32(values[vgetq_lane_s32(index, 3)], value, 3);
}

void sumNeon(const FieldView& field, const PoseColumns& poses, std::size_t begin, std::size_t end,
             const float* x, const float* y, int hits, std::int32_t* sums) {
  const float32x4_t zero = vdupq_n_f32(0.0F);
  const float32x4_t max_u = vdupq_n_f32(field.max_u);
  const float32x4_t max_v = vdupq_n_f32(field.max_v);
  const int32x4_t in_tile_mask = vdupq_n_s32(SparseGrid::kTileRows - 1);
  std::size_t i = begin;
  for (; i + kLanes <= end; i += kLanes) {
    const float32x4_t u = vld1q_f32(poses.u + i);
    const float32x4_t v = vld1q_f32(poses.v + i);
    const float32x4_t c = vld1q_f32(poses.cos + i);
    const float32x4_t s = vld1q_f32(poses.sin + i);
    int32x4_t sum = vdupq_n_s32(0);
    for (int j = 0; j < hits; ++j) {
      const float32x4_t du = vsubq_f32(vmulq_n_f32(c, x[j]), vmulq_n_f32(s, y[j]));
      const float32x4_t dv = vaddq_f32(vmulq_n_f32(s, x[j]), vmulq_n_f32(c, y[j]));
      // maxnm(a, 0) is 0 for a NaN, as in valueAt
      const float32x4_t column = vminq_f32(vmaxnmq_f32(vaddq_f32(u, du), zero), max_u);
      const float32x4_t row = vminq_f32(vmaxnmq_f32(vaddq_f32(v, dv), zero), max_v);
      const int32x4_t row_of = vcvtq_s32_f32(row);
      const int32x4_t in_tile = vandq_s32(row_of, in_tile_mask);
      const int32x4_t strip = vmulq_n_s32(vsubq_s32(row_of, in_tile), field.stride);
      const int32x4_t x_in_strip = vshlq_n_s32(vcvtq_s32_f32(column), kTileRowsLog2);
      const int32x4_t index = vaddq_s32(vaddq_s32(strip, x_in_strip), in_tile);
      const int32x4_t value = looked(field.values, index);
      sum = vaddq_s32(sum, field.list ? looked(field.list, value) : value);
    }
    vst1q_s32(sums + i, sum);
  }
  sumPortable(field, poses, i, end, x, y, hits, sums);
}

}  // namespace

SumKernel fastestSum() {
  return sumNeon;
}
#else
SumKernel fastestSum() {
  return sumPortable;
}
#endif

}  // namespace adaptive_localization
