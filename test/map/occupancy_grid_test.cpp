// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/occupancy_grid.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

TEST(OccupancyGrid, TellsOccupiedFreeAndUnknownApart) {
  const OccupancyGrid grid(Lattice(7, 1, 1.0, {}), {-1, 0, 19, 20, 64, 65, 100});
  const bool occupied[] = {false, false, false, false, false, true, true};
  const bool free[] = {false, true, true, false, false, false, false};
  for (int x = 0; x < 7; ++x) {
    EXPECT_EQ(grid.isOccupied({x, 0}), occupied[x]) << x;
    EXPECT_EQ(grid.isFree({x, 0}), free[x]) << x;
  }
  EXPECT_EQ(grid.countFree(), 2u);
}

TEST(OccupancyGrid, IsUnknownOutside) {
  const OccupancyGrid grid(Lattice(1, 1, 1.0, {}), {100});
  for (const Cell cell : {Cell{-1, 0}, Cell{1, 0}, Cell{0, -1}, Cell{0, 1}}) {
    EXPECT_FALSE(grid.isOccupied(cell));
    EXPECT_FALSE(grid.isFree(cell));
  }
}

TEST(OccupancyGrid, RefusesAWrongNumberOfCells) {
  try {
    OccupancyGrid(Lattice(2, 2, 1.0, {}), {0, 0, 0});
    FAIL() << "took three cells for four";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("3"), testing::HasSubstr("4")));
  }
}

TEST(ToyWorld, HasTheFirstLineOfArtOnTop) {
  const auto map = toyWorld({"#.", "?."}, 0.5, {}, 2);
  EXPECT_EQ(map->lattice().width(), 4);
  EXPECT_TRUE(map->isOccupied(map->lattice().cellAt({0.1, 1.9})));
  EXPECT_TRUE(map->isFree(map->lattice().cellAt({1.9, 1.9})));
  EXPECT_FALSE(map->isFree(map->lattice().cellAt({0.9, 0.1})));
  EXPECT_EQ(map->countFree(), 8u);
}

}  // namespace
}  // namespace adaptive_localization
