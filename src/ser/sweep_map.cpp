// SPDX-License-Identifier: BSD-3-Clause
#include "sweep_map.hpp"

namespace adaptive_localization {

SweepMap::SweepMap(const OccupancyGrid& map, const CellBox& box, bool lines_are_columns,
                   int spacing)
    : lines_(lines_are_columns ? box.width : box.height),
      length_(lines_are_columns ? box.height : box.width),
      words_((length_ + 63) / 64),
      spacing_(spacing),
      obstacles_(at(lines_, length_ + 2)),
      obstacle_bits_(at(lines_, words_)),
      asked_bits_(obstacle_bits_.size()) {
  const int first = lines_are_columns ? box.x : box.y;
  first_u_ = (spacing - first % spacing) % spacing;
  for (int u = 0; u < lines_ && length_ % 64 != 0; ++u) {
    obstacle_bits_[at(u + 1, words_) - 1] = ~std::uint64_t{0} << (length_ % 64);
  }
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      const Cell cell{box.x + x, box.y + y};
      const int u = lines_are_columns ? x : y;
      const int v = lines_are_columns ? y : x;
      const std::size_t word = at(u, words_) + static_cast<std::size_t>(v / 64);
      const std::uint64_t bit = std::uint64_t{1} << (v % 64);
      if (map.endsBeams(cell)) {
        obstacles_[at(u, length_ + 2) + 1 + static_cast<std::size_t>(v)] = 1;
        obstacle_bits_[word] |= bit;
      }
      if (cell.x % spacing == 0 && cell.y % spacing == 0 && map.isFree(cell)) {
        asked_bits_[word] |= bit;
      }
    }
  }
}

}  // namespace adaptive_localization
