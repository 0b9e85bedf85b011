// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/sparse_grid.hpp"

#include <gtest/gtest.h>

#include <set>

#include "adaptive_localization/core/rng.hpp"
#include "support/resident_memory.hpp"

namespace adaptive_localization {
namespace {

TEST(SparseGrid, HoldsWhatIsSetAndZeroElsewhere) {
  SparseGrid grid(131, 67);
  EXPECT_EQ(grid.stride(), 192);
  EXPECT_EQ(grid.tiles(), 9U);
  std::set<std::size_t> places;
  for (int y = 0; y < 67; ++y) {
    for (int x = 0; x < 131; ++x) {
      EXPECT_EQ(grid.at(x, y), 0);
      places.insert(grid.index(x, y));
      grid.set(x, y, static_cast<std::uint16_t>(1 + 131 * y + x));
    }
  }
  EXPECT_EQ(places.size(), 131U * 67U) << "no two share one";
  for (int y = 0; y < 67; ++y) {
    for (int x = 0; x < 131; ++x) ASSERT_EQ(grid.at(x, y), 1 + 131 * y + x);
  }
}

TEST(SparseGrid, TellsWhichTilesWereWritten) {
  SparseGrid grid(200, 100);
  grid.set(130, 40, 7);  // third column, second row of tiles
  for (std::size_t tile = 0; tile < grid.tiles(); ++tile) {
    EXPECT_EQ(grid.isWritten(tile), tile == 4 + 2) << tile;
  }
}

TEST(SparseGrid, TakesNoMemoryForWhatWasNotWritten) {
  const double before = residentMegabytes();
  SparseGrid grid(30000, 30000);  // 1.8 GB, if all of it were written
  Rng rng(1);
  int sum = 0;
  for (int i = 0; i < 1000; ++i) {
    grid.set(static_cast<int>(rng.below(30000)), static_cast<int>(rng.below(30000)), 1);
    sum += grid.at(static_cast<int>(rng.below(30000)), static_cast<int>(rng.below(30000)));
  }
  EXPECT_LT(residentMegabytes() - before, 20.0);
  EXPECT_LT(sum, 10);
}

TEST(SparseGrid, CopiesWhatWasWritten) {
  SparseGrid grid(300, 300);
  grid.set(70, 40, 7);
  SparseGrid copy = grid;
  copy.set(299, 299, 8);
  EXPECT_EQ(copy.at(70, 40), 7);
  EXPECT_EQ(copy.at(299, 299), 8);
  EXPECT_EQ(grid.at(299, 299), 0) << "a copy of its own";
  int written = 0;
  for (std::size_t tile = 0; tile < copy.tiles(); ++tile) written += copy.isWritten(tile) ? 1 : 0;
  EXPECT_EQ(written, 2);
}

}  // namespace
}  // namespace adaptive_localization
