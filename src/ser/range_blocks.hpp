// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>

#include "adaptive_localization/ser/range_table.hpp"

namespace adaptive_localization {

/// The cells of a range table in square blocks, and what can be seen from anywhere in a block: the
/// least and the greatest range in each direction.
class RangeBlocks {
 public:
  static constexpr int kSide = 4;  // cells

  explicit RangeBlocks(const RangeTable& table);

  /// What was made before.
  struct Arrays {
    ConstArray<std::uint32_t> cells;   // block by block
    ConstArray<std::uint32_t> starts;  // of each block in cells, and the end
    ConstArray<std::uint8_t> low, high;
  };
  explicit RangeBlocks(Arrays arrays) : arrays_(std::move(arrays)) {}
  const Arrays& arrays() const { return arrays_; }

  std::size_t size() const { return arrays_.starts.size() - 1; }
  const std::uint8_t* low(std::size_t block) const { return at(arrays_.low, block); }
  const std::uint8_t* high(std::size_t block) const { return at(arrays_.high, block); }

  /// The block's cells: numbers of the table.
  const std::uint32_t* begin(std::size_t block) const {
    return arrays_.cells.data() + arrays_.starts[block];
  }
  const std::uint32_t* end(std::size_t block) const {
    return arrays_.cells.data() + arrays_.starts[block + 1];
  }

  std::size_t bytes() const;

 private:
  static const std::uint8_t* at(const ConstArray<std::uint8_t>& ranges, std::size_t block) {
    return ranges.data() + block * RangeTable::kStride;
  }

  Arrays arrays_;
};

}  // namespace adaptive_localization
