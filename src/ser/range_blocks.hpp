// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "adaptive_localization/map/lattice.hpp"
#include "ser/const_array.hpp"
#include "ser/scan_energy.hpp"

namespace adaptive_localization {

/// The cells of a range table in square blocks, and what can be seen from anywhere in a block: the
/// least and the greatest range in each direction.
class RangeBlocks {
 public:
  static constexpr int kSide = 4;  // cells

  /// Of every `spacing`-th cell of a lattice, by their indices, each with a row of ranges.
  RangeBlocks(const Lattice& lattice, int spacing, const ConstArray<std::uint32_t>& cells,
              const ConstArray<std::uint8_t>& ranges);

  std::size_t size() const { return starts_.size() - 1; }
  const std::uint8_t* low(std::size_t block) const { return at(low_, block); }
  const std::uint8_t* high(std::size_t block) const { return at(high_, block); }

  /// The block's cells: numbers of the table.
  const std::uint32_t* begin(std::size_t block) const { return cells_.data() + starts_[block]; }
  const std::uint32_t* end(std::size_t block) const { return cells_.data() + starts_[block + 1]; }

  std::size_t bytes() const;

 private:
  static const std::uint8_t* at(const std::vector<std::uint8_t>& ranges, std::size_t block) {
    return ranges.data() + block * kRangeStride;
  }

  std::vector<std::uint32_t> cells_;   // block by block
  std::vector<std::uint32_t> starts_;  // of each block in cells_, and the end
  std::vector<std::uint8_t> low_, high_;
};

}  // namespace adaptive_localization
