// SPDX-License-Identifier: BSD-3-Clause
#include "distance_kernel.hpp"

#include <algorithm>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace adaptive_localization {
namespace {

double stepsAt(const NearnessView& field, const PointFrame& frame, double px, double py) {
  return stepsBetween(field, frame.x + frame.c * px - frame.s * py,
                      frame.y + frame.s * px + frame.c * py);
}

}  // namespace

double sumOfStepsPortable(const NearnessView& field, const PointFrame& frame,
                          const PointColumns& points, double most) {
  double sum = 0.0;
  for (std::ptrdiff_t i = 0; i < points.count; i += points.stride) {
    sum += std::min(stepsAt(field, frame, points.x[i], points.y[i]), most);
  }
  return sum;
}

#if defined(__x86_64__)
namespace {

constexpr int kLanes = 4;

/// What four cells are away from walls, in steps; one by one, as many processors take longer for a
/// gather.
__attribute__((target("avx2"))) inline __m256d stepsIn(const NearnessView& field, __m128i index) {
  const std::int64_t a = _mm_cvtsi128_si64(index), b = _mm_extract_epi64(index, 1);
  const auto at = [&field](std::int64_t pair, int shift) {
    return field.values[static_cast<std::uint32_t>(static_cast<std::uint64_t>(pair) >> shift)];
  };
  __m128i nearness = _mm_cvtsi32_si128(at(a, 0));
  nearness = _mm_insert_epi16(nearness, at(a, 32), 1);
  nearness = _mm_insert_epi16(nearness, at(b, 0), 2);
  nearness = _mm_insert_epi16(nearness, at(b, 32), 3);
  return _mm256_cvtepi32_pd(
      _mm_sub_epi32(_mm_set1_epi32(field.reach), _mm_cvtepu16_epi32(nearness)));
}

__attribute__((target("avx2"))) inline __m256d blended(__m256d a, __m256d b, __m256d share) {
  return _mm256_add_pd(a, _mm256_mul_pd(share, _mm256_sub_pd(b, a)));
}

/// Of four points; false if some of them has not four cells around it.
__attribute__((target("avx2"))) inline bool stepsOfFour(const NearnessView& field, __m256d x,
                                                        __m256d y, __m256d& steps) {
  const __m256d one = _mm256_set1_pd(1.0);
  const __m128i next = _mm_set1_epi32(1), in_tile_mask = _mm_set1_epi32(SparseGrid::kTileRows - 1);
  const __m128i column = _mm256_cvttpd_epi32(_mm256_add_pd(x, one));  // in the table
  const __m128i row = _mm256_cvttpd_epi32(_mm256_add_pd(y, one));
  const __m128i are_low = _mm_or_si128(_mm_cmplt_epi32(column, next), _mm_cmplt_epi32(row, next));
  const __m128i are_high = _mm_or_si128(_mm_cmpgt_epi32(column, _mm_set1_epi32(field.columns - 1)),
                                        _mm_cmpgt_epi32(row, _mm_set1_epi32(field.rows - 1)));
  if (_mm_movemask_epi8(_mm_or_si128(are_low, are_high)) != 0) return false;

  const __m128i in_tile = _mm_and_si128(row, in_tile_mask);
  const __m128i strip = _mm_mullo_epi32(_mm_sub_epi32(row, in_tile), _mm_set1_epi32(field.stride));
  const __m128i tile = _mm_mullo_epi32(column, _mm_set1_epi32(SparseGrid::kTileRows));
  const __m128i low = _mm_add_epi32(_mm_add_epi32(strip, tile), in_tile);
  const __m128i to_next_strip =
      _mm_set1_epi32(SparseGrid::kTileRows * field.stride - SparseGrid::kTileRows + 1);
  const __m128i is_last = _mm_cmpeq_epi32(in_tile, in_tile_mask);
  const __m128i high = _mm_add_epi32(low, _mm_blendv_epi8(next, to_next_strip, is_last));
  const __m128i across = _mm_set1_epi32(SparseGrid::kTileRows);
  const __m256d a = stepsIn(field, low), b = stepsIn(field, _mm_add_epi32(low, across));
  const __m256d c = stepsIn(field, high), d = stepsIn(field, _mm_add_epi32(high, across));

  const __m256d share_x = _mm256_sub_pd(x, _mm256_cvtepi32_pd(_mm_sub_epi32(column, next)));
  const __m256d share_y = _mm256_sub_pd(y, _mm256_cvtepi32_pd(_mm_sub_epi32(row, next)));
  const __m256d below = blended(a, b, share_x);
  const __m256d above = blended(c, d, share_x);
  steps = blended(below, above, share_y);
  return true;
}

__attribute__((target("avx2"))) double sumOfStepsAvx2(const NearnessView& field,
                                                      const PointFrame& frame,
                                                      const PointColumns& points, double most) {
  const __m256d frame_x = _mm256_set1_pd(frame.x), frame_y = _mm256_set1_pd(frame.y);
  const __m256d c = _mm256_set1_pd(frame.c), s = _mm256_set1_pd(frame.s);
  const __m256d limit = _mm256_set1_pd(most);
  const std::ptrdiff_t stride = points.stride;
  double sum = 0.0;
  std::ptrdiff_t i = 0;
  for (; i + (kLanes - 1) * stride < points.count; i += kLanes * stride) {
    const float* px = points.x + i;
    const float* py = points.y + i;
    const __m256d x = _mm256_set_pd(px[3 * stride], px[2 * stride], px[stride], px[0]);
    const __m256d y = _mm256_set_pd(py[3 * stride], py[2 * stride], py[stride], py[0]);
    const __m256d at_x =
        _mm256_sub_pd(_mm256_add_pd(frame_x, _mm256_mul_pd(c, x)), _mm256_mul_pd(s, y));
    const __m256d at_y =
        _mm256_add_pd(_mm256_add_pd(frame_y, _mm256_mul_pd(s, x)), _mm256_mul_pd(c, y));
    alignas(32) double steps[kLanes];
    if (__m256d of_four; stepsOfFour(field, at_x, at_y, of_four)) {
      _mm256_store_pd(steps, _mm256_min_pd(of_four, limit));
      for (const double each : steps) sum += each;  // in the same order as one by one
    } else {
      for (int k = 0; k < kLanes; ++k) {
        sum += std::min(stepsAt(field, frame, px[k * stride], py[k * stride]), most);
      }
    }
  }
  for (; i < points.count; i += stride) {
    sum += std::min(stepsAt(field, frame, points.x[i], points.y[i]), most);
  }
  return sum;
}

}  // namespace

DistanceKernel fastestSumOfSteps() {
  return __builtin_cpu_supports("avx2") ? sumOfStepsAvx2 : sumOfStepsPortable;
}
#else
DistanceKernel fastestSumOfSteps() {
  return sumOfStepsPortable;
}
#endif

}  // namespace adaptive_localization
