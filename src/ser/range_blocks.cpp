// SPDX-License-Identifier: BSD-3-Clause
#include "range_blocks.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "adaptive_localization/parallel.hpp"

namespace adaptive_localization {

RangeBlocks::RangeBlocks(const RangeTable& table) {
  const int side = kSide * table.spacing();
  const auto blocks_per_row =
      static_cast<std::uint32_t>((table.lattice().width() + side - 1) / side);
  std::vector<std::uint32_t> block_of(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Cell cell = table.cell(i);
    block_of[i] = static_cast<std::uint32_t>(cell.y / side) * blocks_per_row +
                  static_cast<std::uint32_t>(cell.x / side);
  }
  std::vector<std::uint32_t> cells(table.size());
  std::iota(cells.begin(), cells.end(), 0U);
  std::stable_sort(cells.begin(), cells.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return block_of[a] < block_of[b]; });
  std::vector<std::uint32_t> starts;
  for (std::uint32_t k = 0; k < cells.size(); ++k) {
    if (k == 0 || block_of[cells[k]] != block_of[cells[k - 1]]) starts.push_back(k);
  }
  starts.push_back(static_cast<std::uint32_t>(cells.size()));
  arrays_.cells = ConstArray<std::uint32_t>(std::move(cells));
  arrays_.starts = ConstArray<std::uint32_t>(std::move(starts));

  std::vector<std::uint8_t> lows(size() * RangeTable::kStride, kNoReturn);
  std::vector<std::uint8_t> highs(size() * RangeTable::kStride, 0);
  parallelFor(size(), 256, [&](const Chunk& chunk) {
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      std::uint8_t* low = lows.data() + b * RangeTable::kStride;
      std::uint8_t* high = highs.data() + b * RangeTable::kStride;
      for (const std::uint32_t* cell = begin(b); cell != end(b); ++cell) {
        const std::uint8_t* ranges = table.ranges(*cell);
        for (std::size_t d = 0; d < RangeTable::kStride; ++d) {
          low[d] = std::min(low[d], ranges[d]);
          high[d] = std::max(high[d], ranges[d]);
        }
      }
    }
  });
  arrays_.low = ConstArray<std::uint8_t>(std::move(lows));
  arrays_.high = ConstArray<std::uint8_t>(std::move(highs));
}

std::size_t RangeBlocks::bytes() const {
  return arrays_.low.bytes() + arrays_.high.bytes() + arrays_.cells.bytes() +
         arrays_.starts.bytes();
}

}  // namespace adaptive_localization
