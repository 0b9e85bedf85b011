// SPDX-License-Identifier: BSD-3-Clause
#include "beam_paths.hpp"

#include <algorithm>

namespace adaptive_localization {
namespace {

using Bits = std::vector<std::uint64_t>;

/// Moves bits by -1, 0 or 1; what leaves the line is lost, or ends at the obstacles beyond.
void shift(int by, Bits& bits) {
  if (by > 0) {
    for (std::size_t w = bits.size(); w-- > 1;) bits[w] = bits[w] << 1 | bits[w - 1] >> 63;
    bits[0] <<= 1;
  } else if (by < 0) {
    for (std::size_t w = 0; w + 1 < bits.size(); ++w) bits[w] = bits[w] >> 1 | bits[w + 1] << 63;
    bits.back() >>= 1;
  }
}

void remove(const std::uint64_t* some, Bits& bits) {
  for (std::size_t w = 0; w < bits.size(); ++w) bits[w] &= ~some[w];
}

void add(const std::uint64_t* some, Bits& bits) {
  for (std::size_t w = 0; w < bits.size(); ++w) bits[w] |= some[w];
}

}  // namespace

BeamPaths::BeamPaths(const SweepMap& map, const SweepDirection& direction, int bundle,
                     const DigitalLine& line)
    : length_(map.length()),
      words_(static_cast<std::size_t>(map.words() + kBlock - 1) / kBlock),
      marks_(static_cast<std::size_t>(map.lines()) * words_) {
  constexpr int kFew = 4;  // words of a line, which are looked at sooner than thought about
  if (map.words() <= kFew) {
    std::fill(marks_.begin(), marks_.end(),
              ~std::uint64_t{0} >> (64 - (length_ + kBlock - 1) / kBlock));
    return;
  }
  Bits along(static_cast<std::size_t>(map.words()));
  for (int t = 0; t < map.lines(); ++t) {
    const int u = direction.sense > 0 ? t : map.lines() - 1 - t;
    if (t > 0) {
      const LineStep& step = line.stepAfter(t - 1);
      if (step.shift != 0 && !step.side_is_on_this_line) remove(map.obstacleBits(u), along);
      shift(step.shift, along);
      if (step.side_is_on_this_line) remove(map.obstacleBits(u - direction.sense), along);
      remove(map.obstacleBits(u), along);
    }
    const bool begins = map.isAskedFor(u) && nearestBundle(t, direction.slope) == bundle;
    if (begins) add(map.askedBits(u), along);
    mark(t, along);
  }
}

void BeamPaths::mark(int t, const Bits& cells) {
  std::uint64_t* marks = marks_.data() + static_cast<std::size_t>(t) * words_;
  for (std::size_t w = 0; w < cells.size(); ++w) {
    const bool is_low = static_cast<std::uint32_t>(cells[w]) != 0;
    const bool is_high = cells[w] >> kBlock != 0;
    const std::uint64_t blocks = (is_high ? 2U : 0U) | (is_low ? 1U : 0U);
    marks[w / kBlock] |= blocks << (2 * w % 64);
  }
}

}  // namespace adaptive_localization
