// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace adaptive_localization {

/// A direction in which each step of a sweep leads to the next of its lines.
struct SweepDirection {
  int sense;     // of u, the number of a line: 1 or -1
  double slope;  // of v, the place on a line, in [-1, 1]
};

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
inline int floorOf(double x) {
  const int truncated = static_cast<int>(x);
  return truncated - (x < truncated ? 1 : 0);
}

/// The bundle of lines that passes nearest to the middles of line t's cells.
inline int nearestBundle(int t, double slope) {
  const int nearest = floorOf(-slope * t * kBundles + 0.5) % kBundles;
  return nearest < 0 ? nearest + kBundles : nearest;
}

/// The steps of the digital lines v = floor(slope t + start + 1/2), which are the same for all of a
/// bundle: start is the bundle's share of a cell.
class DigitalLine {
 public:
  /// From line 0 to the last of so many.
  DigitalLine(double slope, int bundle, int lines)
      : slope_(slope),
        start_(static_cast<double>(bundle) / kBundles),
        length_(std::sqrt(1.0 + slope * slope)) {
    steps_.reserve(static_cast<std::size_t>(lines));
    int now = at(0);
    for (int t = 0; t + 1 < lines; ++t) {
      const int next = at(t + 1);
      steps_.push_back(stepBetween(t, now, next));
      now = next;
    }
  }

  double stepLength() const { return length_; }

  /// From line t to t + 1.
  const LineStep& stepAfter(int t) const { return steps_[static_cast<std::size_t>(t)]; }

 private:
  int at(int t) const { return floorOf(slope_ * t + start_ + 0.5); }

  LineStep stepBetween(int t, int now, int next) const {
    const int shift = next - now;
    LineStep step{shift, false, static_cast<float>(length_), static_cast<float>(0.5 * length_),
                  0.0F};
    if (shift == 0) return step;
    // where the border between v and v + shift is crossed
    const double crossing = (now + 0.5 * shift - start_) / slope_ - t;
    step.side_is_on_this_line = crossing < 0.5;
    step.to_side = static_cast<float>(std::min(crossing, 0.5) * length_);
    step.to_next = static_cast<float>(std::max(crossing, 0.5) * length_);
    return step;
  }

  double slope_, start_;
  double length_;  // of a step, in cells
  std::vector<LineStep> steps_;
};

}  // namespace adaptive_localization
