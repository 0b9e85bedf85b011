// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

constexpr float kFree = std::numeric_limits<float>::infinity();

/// Lines are swept in so many bundles, one beside the other: a cell's own line is a bundle's that
/// is off by half of one part of a cell at the most.
constexpr int kBundles = 4;

/// From one line to the next the digital line advances by `shift` (-1, 0, 1) in v; on a slanted
/// step it passes through one more cell. Distances are measured along the ray, in cells, from where
/// it leaves the middle of the first line.
struct LineStep {
  int shift;
  bool side_is_on_this_line;  // the cell passed on a slanted step: on this line or on the next
  float length;               // of the whole step
  float to_next;              // where the next line's cell is entered
  float to_side;              // where the cell in between is entered
};

/// std::floor for what fits into an int, without a call.
int floorOf(double x) {
  const int truncated = static_cast<int>(x);
  return truncated - (x < truncated ? 1 : 0);
}

/// The step from line t to t + 1 of the digital line v = floor(slope t + start + 1/2).
LineStep stepAfter(int t, double slope, double start, double length) {
  const int now = floorOf(slope * t + start + 0.5);
  const int shift = floorOf(slope * (t + 1) + start + 0.5) - now;
  LineStep step{shift, false, static_cast<float>(length), static_cast<float>(0.5 * length), 0.0F};
  if (shift == 0) return step;
  // where the border between v and v + shift is crossed
  const double crossing = (now + 0.5 * shift - start) / slope - t;
  step.side_is_on_this_line = crossing < 0.5;
  step.to_side = static_cast<float>(std::min(crossing, 0.5) * length);
  step.to_next = static_cast<float>(std::max(crossing, 0.5) * length);
  return step;
}

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

/// The bundle of lines that passes nearest to the middles of line t's cells.
int nearestBundle(int t, double slope) {
  const int nearest = floorOf(-slope * t * kBundles + 0.5) % kBundles;
  return nearest < 0 ? nearest + kBundles : nearest;
}

/// Sweeps all lines that start some bundle / kBundles above the middle of a cell.
class BundleSweep {
 public:
  BundleSweep(const SweepMap& map, const Sweep& request, int bundle)
      : map_(map),
        request_(request),
        bundle_(bundle),
        start_(static_cast<double>(bundle) / kBundles),
        length_(std::sqrt(1.0 + request.slope * request.slope)),
        seen_(static_cast<std::size_t>(map.length + 2), kFree),
        result_(seen_.size(), kFree),
        steps_(static_cast<std::size_t>(map.length)) {}

  /// Goes back from line t + 1 to t.
  void step(int t) {
    const int u = request_.sense > 0 ? t : map_.lines - 1 - t;
    if (t < map_.lines - 1) {
      const LineStep step = stepAfter(t, request_.slope, start_, length_);
      kStepBack(step, map_.line(u), map_.line(u + request_.sense), seen_.data() + 1, map_.length,
                result_.data() + 1);
      seen_.swap(result_);
    }
    const bool is_asked_for = u % request_.spacing == request_.first_u;
    if (is_asked_for && nearestBundle(t, request_.slope) == bundle_) write(u);
  }

 private:
  void write(int u) {
    std::uint8_t* out =
        request_.steps + static_cast<std::size_t>(u / request_.spacing) * request_.pitch;
    const auto inside = static_cast<float>(0.5 * length_);  // half a step: to the cell's middle
    if (request_.spacing == 1) {
      kRound(seen_.data() + 1, map_.length, inside, request_.scale, out);
      return;
    }
    kRound(seen_.data() + 1, map_.length, inside, request_.scale, steps_.data());
    for (int v = request_.first_v; v < map_.length; v += request_.spacing) {
      *out++ = steps_[static_cast<std::size_t>(v)];
    }
  }

  const SweepMap& map_;
  const Sweep& request_;
  int bundle_;
  double start_;
  double length_;                     // of a step from line to line
  std::vector<float> seen_, result_;  // one border cell at both ends, beyond which nothing is seen
  std::vector<std::uint8_t> steps_;
};

}  // namespace

CellBox knownCells(const OccupancyGrid& map) {
  const Lattice& lattice = map.lattice();
  int low_x = lattice.width(), low_y = lattice.height(), high_x = -1, high_y = -1;
  for (std::size_t i = 0; i < map.cells().size(); ++i) {
    if (map.cells()[i] < 0) continue;
    const Cell cell = lattice.cell(i);
    low_x = std::min(low_x, cell.x);
    low_y = std::min(low_y, cell.y);
    high_x = std::max(high_x, cell.x);
    high_y = std::max(high_y, cell.y);
  }
  if (high_x < 0) return {0, 0, 0, 0};
  return {low_x, low_y, high_x - low_x + 1, high_y - low_y + 1};
}

SweepMap sweepMapOf(const OccupancyGrid& map, const CellBox& box, bool lines_are_columns) {
  SweepMap result;
  result.lines = lines_are_columns ? box.width : box.height;
  result.length = lines_are_columns ? box.height : box.width;
  const auto pitch = static_cast<std::size_t>(result.length + 2);
  result.obstacle.assign(static_cast<std::size_t>(result.lines) * pitch, 0);
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      if (!map.endsBeams({box.x + x, box.y + y})) continue;
      const auto u = static_cast<std::size_t>(lines_are_columns ? x : y);
      const auto v = static_cast<std::size_t>(lines_are_columns ? y : x);
      result.obstacle[u * pitch + 1 + v] = 1;
    }
  }
  return result;
}

void sweep(const SweepMap& map, const Sweep& request, const StopToken& stop) {
  std::vector<BundleSweep> bundles;
  for (int bundle = 0; bundle < kBundles; ++bundle) bundles.emplace_back(map, request, bundle);
  for (int t = map.lines - 1; t >= 0; --t) {  // together, to read the map's lines once
    stop.check();
    for (BundleSweep& bundle : bundles) bundle.step(t);
  }
}

}  // namespace adaptive_localization
