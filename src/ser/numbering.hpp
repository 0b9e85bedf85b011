// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace adaptive_localization {

/// Numbers some of many cells, in their order, with a bit and half a bit for each.
class Numbering {
 public:
  explicit Numbering(std::size_t cells) : marks_(cells / kBits + 1), before_(marks_.size()) {}

  /// In ascending order.
  void mark(std::size_t cell) {
    marks_[cell / kBits] |= bitOf(cell);
    for (; counted_ < cell / kBits; ++counted_) {
      before_[counted_ + 1] = before_[counted_] + ones(marks_[counted_]);
    }
  }

  bool isMarked(std::size_t cell) const { return (marks_[cell / kBits] & bitOf(cell)) != 0; }

  std::size_t number(std::size_t cell) const {
    return before_[cell / kBits] + ones(marks_[cell / kBits] & (bitOf(cell) - 1));
  }

 private:
  static constexpr std::size_t kBits = 64;
  static std::uint64_t bitOf(std::size_t cell) { return std::uint64_t{1} << (cell % kBits); }
  static std::uint32_t ones(std::uint64_t word) {
    return static_cast<std::uint32_t>(__builtin_popcountll(word));
  }

  std::vector<std::uint64_t> marks_;
  std::vector<std::uint32_t> before_;  // marks before a word's; right up to the last word marked
  std::size_t counted_{0};
};

}  // namespace adaptive_localization
