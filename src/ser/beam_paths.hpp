// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "digital_line.hpp"
#include "sweep_map.hpp"

namespace adaptive_localization {

/// The cells of a SweepMap that beams of one bundle come along, which leave the cells that are
/// asked for and end at obstacles: what a sweep has to look at, and some more, in runs of whole
/// blocks of cells. In a building with courtyards, or on a map of which little is known, that is a
/// small part of it.
class BeamPaths {
 public:
  BeamPaths(const SweepMap& map, const SweepDirection& direction, int bundle,
            const DigitalLine& line);

  /// Calls visit(first, end) for runs of cells of line number t, counted along the direction.
  template <class Visitor>
  void forEachRun(int t, Visitor&& visit) const {
    const std::uint64_t* marks = marks_.data() + static_cast<std::size_t>(t) * words_;
    for (std::size_t word = 0; word < words_; ++word) {
      const int first = static_cast<int>(word) * 64;
      for (std::uint64_t left = marks[word]; left != 0;) {
        const int begin = __builtin_ctzll(left);
        left |= left - 1;  // from the lowest bit down
        const int end = ~left != 0 ? __builtin_ctzll(~left) : 64;
        visit((first + begin) * kBlock, std::min((first + end) * kBlock, length_));
        left &= left + 1;
      }
    }
  }

 private:
  static constexpr int kBlock = 32;  // cells: half a word of theirs

  void mark(int t, const std::vector<std::uint64_t>& cells);

  int length_;
  std::size_t words_;  // of marks to a line
  std::vector<std::uint64_t> marks_;
};

}  // namespace adaptive_localization
