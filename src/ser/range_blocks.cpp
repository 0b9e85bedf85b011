// SPDX-License-Identifier: BSD-3-Clause
#include "range_blocks.hpp"

#include <algorithm>
#include <numeric>

#include "core/parallel.hpp"

namespace adaptive_localization {

RangeBlocks::RangeBlocks(const Lattice& lattice, int spacing,
                         const ConstArray<std::uint32_t>& cells,
                         const ConstArray<std::uint8_t>& ranges) {
  const int side = kSide * spacing;
  const auto blocks_per_row = static_cast<std::uint32_t>((lattice.width() + side - 1) / side);
  std::vector<std::uint32_t> block_of(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = lattice.cell(cells[i]);
    block_of[i] = static_cast<std::uint32_t>(cell.y / side) * blocks_per_row +
                  static_cast<std::uint32_t>(cell.x / side);
  }
  cells_.resize(cells.size());
  std::iota(cells_.begin(), cells_.end(), 0U);
  std::stable_sort(cells_.begin(), cells_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return block_of[a] < block_of[b]; });
  for (std::uint32_t k = 0; k < cells_.size(); ++k) {
    if (k == 0 || block_of[cells_[k]] != block_of[cells_[k - 1]]) starts_.push_back(k);
  }
  starts_.push_back(static_cast<std::uint32_t>(cells_.size()));

  low_.assign(size() * kRangeStride, kNoReturn);
  high_.assign(size() * kRangeStride, 0);
  parallelFor(size(), 256, [&](const Chunk& chunk) {
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      std::uint8_t* low = low_.data() + b * kRangeStride;
      std::uint8_t* high = high_.data() + b * kRangeStride;
      for (const std::uint32_t* cell = begin(b); cell != end(b); ++cell) {
        const std::uint8_t* row = ranges.data() + *cell * kRangeStride;
        for (std::size_t d = 0; d < kRangeStride; ++d) {
          low[d] = std::min(low[d], row[d]);
          high[d] = std::max(high[d], row[d]);
        }
      }
    }
  });
}

std::size_t RangeBlocks::bytes() const {
  return low_.size() + high_.size() + (cells_.size() + starts_.size()) * sizeof(std::uint32_t);
}

}  // namespace adaptive_localization
