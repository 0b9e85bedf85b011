// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

constexpr float kFree = std::numeric_limits<float>::infinity();

/// How far is seen where an obstacle would be entered after some way.
inline __attribute__((always_inline)) float until(std::uint8_t obstacle, float way) {
  return obstacle != 0 ? way : kFree;
}

/// What is seen from the cells of a line, from what is seen from those of the next.
inline __attribute__((always_inline)) void stepBackBody(const LineStep& step,
                                                        const std::uint8_t* here,
                                                        const std::uint8_t* next, const float* seen,
                                                        int length, float* result) {
  const std::uint8_t* ahead = next + step.shift;
  const float* seen_ahead = seen + step.shift;
  if (step.shift == 0) {
    for (int v = 0; v < length; ++v) {
      result[v] = std::min(seen_ahead[v] + step.length, until(ahead[v], step.to_next));
    }
    return;
  }
  const std::uint8_t* side = step.side_is_on_this_line ? here + step.shift : next;
  for (int v = 0; v < length; ++v) {
    const float far = std::min(seen_ahead[v] + step.length, until(ahead[v], step.to_next));
    result[v] = std::min(far, until(side[v], step.to_side));
  }
}

/// Rounds distances from where obstacles are entered to those of the surfaces in them.
inline __attribute__((always_inline)) void roundBody(const float* seen, int length, float inside,
                                                     float scale, std::uint8_t* steps) {
  const float offset = inside * scale + 0.5F;
  for (int v = 0; v < length; ++v) {
    steps[v] = static_cast<std::uint8_t>(std::min(seen[v] * scale + offset, 255.0F));
  }
}

using StepBack = void (*)(const LineStep&, const std::uint8_t*, const std::uint8_t*, const float*,
                          int, float*);
using Round = void (*)(const float*, int, float, float, std::uint8_t*);

void stepBackPortable(const LineStep& step, const std::uint8_t* here, const std::uint8_t* next,
                      const float* seen, int length, float* result) {
  stepBackBody(step, here, next, seen, length, result);
}
void roundPortable(const float* seen, int length, float inside, float scale, std::uint8_t* steps) {
  roundBody(seen, length, inside, scale, steps);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void stepBackAvx2(const LineStep& step, const std::uint8_t* here,
                                                  const std::uint8_t* next, const float* seen,
                                                  int length, float* result) {
  stepBackBody(step, here, next, seen, length, result);
}
__attribute__((target("avx2"))) void roundAvx2(const float* seen, int length, float inside,
                                               float scale, std::uint8_t* steps) {
  roundBody(seen, length, inside, scale, steps);
}
bool hasAvx2() {
  return __builtin_cpu_supports("avx2") != 0;
}
const StepBack kStepBack = hasAvx2() ? stepBackAvx2 : stepBackPortable;
const Round kRound = hasAvx2() ? roundAvx2 : roundPortable;
#else
constexpr StepBack kStepBack = stepBackPortable;
constexpr Round kRound = roundPortable;
#endif

}  // namespace

BundleSweep::BundleSweep(const SweepMap& map, const SweepDirection& direction, int bundle)
    : map_(map),
      direction_(direction),
      line_(direction.slope, bundle, map.lines()),
      paths_(map, direction, bundle, line_),
      seen_(static_cast<std::size_t>(map.length() + 2), kFree),
      result_(seen_) {}

/// Where no beam comes along, what was seen from lines farther off is left: it is of no use to a
/// beam, as that ends before.
void BundleSweep::stepTo(int t) {
  if (t == map_.lines() - 1) return;
  const int u = direction_.sense > 0 ? t : map_.lines() - 1 - t;
  const LineStep& step = line_.stepAfter(t);
  const std::uint8_t* here = map_.obstacles(u);
  const std::uint8_t* next = map_.obstacles(u + direction_.sense);
  paths_.forEachRun(t, [&](int first, int end) {
    kStepBack(step, here + first, next + first, seen_.data() + 1 + first, end - first,
              result_.data() + 1 + first);
  });
  seen_.swap(result_);
}

void BundleSweep::write(int t, float scale, std::uint8_t* ranges) const {
  const auto inside =
      static_cast<float>(0.5 * line_.stepLength());  // half a step: to the cell's middle
  paths_.forEachRun(t, [&](int first, int end) {
    kRound(seen_.data() + 1 + first, end - first, inside, scale, ranges + first);
  });
}

Sweep::Sweep(const SweepMap& map, const SweepDirection& direction, float scale)
    : map_(map), direction_(direction), scale_(scale) {
  bundles_.reserve(kBundles);
  for (int bundle = 0; bundle < kBundles; ++bundle) bundles_.emplace_back(map, direction, bundle);
}

void Sweep::advance(int first, int end, std::uint8_t* ranges) {
  const bool is_forward = direction_.sense > 0;
  for (int n = 0; n < end - first; ++n) {
    const int u = is_forward ? end - 1 - n : first + n;
    const int t = is_forward ? u : map_.lines() - 1 - u;
    for (BundleSweep& bundle : bundles_) bundle.stepTo(t);  // together: they read the same lines
    if (!map_.isAskedFor(u)) continue;
    const auto nearest = static_cast<std::size_t>(nearestBundle(t, direction_.slope));
    const auto line = static_cast<std::size_t>(map_.askedBefore(u) - map_.askedBefore(first));
    bundles_[nearest].write(t, scale_, ranges + line * static_cast<std::size_t>(map_.length()));
  }
}

}  // namespace adaptive_localization
