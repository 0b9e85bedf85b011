// SPDX-License-Identifier: BSD-3-Clause
#include "map/thin_walls.hpp"

#include <gtest/gtest.h>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// A wall of so many cells across a hall, cells of 5 cm.
std::shared_ptr<const OccupancyGrid> hallWithWall(int cells) {
  Art art(40, std::string(60, '.'));
  for (int row = 0; row < cells; ++row) art[static_cast<std::size_t>(15 + row)].assign(60, '#');
  return toyWorld(art, 0.05);
}

int occupiedInColumn(const OccupancyGrid& map, int x) {
  int count = 0;
  for (int y = 0; y < map.lattice().height(); ++y) count += map.isOccupied({x, y}) ? 1 : 0;
  return count;
}

TEST(ThinWalls, ThickWallsShrinkToTheirMiddles) {
  for (const int cells : {5, 8}) {
    const OccupancyGrid thin = withThinWalls(*hallWithWall(cells), 0.05 * cells);
    const double middle = 40 - 1 - (15 + 0.5 * (cells - 1));  // rows of art run downwards
    for (int x = 5; x < 55; ++x) {
      const int count = occupiedInColumn(thin, x);
      EXPECT_GE(count, 1) << cells;
      EXPECT_LE(count, 3) << cells;
      for (int y = 0; y < 40; ++y) {
        if (!thin.isOccupied({x, y})) continue;
        EXPECT_NEAR(y, middle, 1.0) << cells;
      }
    }
  }
}

TEST(ThinWalls, HollowOnesKeepTheirFaces) {
  for (const int cells : {1, 2, 5}) {
    const auto whole = hallWithWall(cells);
    const OccupancyGrid hollow = withHollowWalls(*whole);
    const int first = 40 - 15 - cells, last = 40 - 1 - 15;  // rows of art run downwards
    for (int y = 0; y < 40; ++y) {
      EXPECT_EQ(hollow.isOccupied({30, y}), y == first || y == last) << cells << ", row " << y;
      EXPECT_NE(hollow.isOccupied({30, y}), hollow.isFree({30, y})) << cells << ", row " << y;
    }
  }
}

TEST(ThinWalls, UnknownGroundStaysUnknown) {
  const auto map = toyWorld({"??????", "######", "######", "######", "######", "......"}, 0.05);
  const OccupancyGrid thin = withThinWalls(*map, 0.2);
  for (int x = 0; x < 6; ++x) {
    EXPECT_FALSE(thin.isFree({x, 5}));
    EXPECT_FALSE(thin.isOccupied({x, 5}));
  }
}

}  // namespace
}  // namespace adaptive_localization
