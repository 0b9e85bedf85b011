// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/occupancy_grid.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

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

TEST(OccupancyGrid, TakesPatchesLaterOnesOverEarlierOnes) {
  const OccupancyGrid grid(Lattice(3, 2, 1.0, {}), {0, 0, 0, 0, 0, 0});
  const OccupancyGrid other = grid.with({{{1, 0}, 2, 2, {1, 2, 3, 4}}, {{2, 1}, 1, 1, {-1}}});
  EXPECT_THAT(other.cells(), testing::ElementsAre(0, 1, 2, 0, 3, -1));
  EXPECT_TRUE(other.lattice() == grid.lattice());
  EXPECT_THAT(grid.with({}).cells(), testing::Each(0));
}

TEST(OccupancyGrid, RefusesPatchesThatDoNotFit) {
  const OccupancyGrid grid(Lattice(4, 3, 1.0, {}), std::vector<std::int8_t>(12, 0));
  const auto error = [&](const MapPatch& patch) -> std::string {
    try {
      grid.with({patch});
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "none";
  };
  EXPECT_EQ(error({{0, 0}, 4, 3, std::vector<std::int8_t>(12, 1)}), "none");
  EXPECT_EQ(error({{1, 1}, 2, 2, {1, 2, 3}}),
            "map update: got 3 cells for 2 x 2 at (1, 1), expected 4");
  constexpr int kMost = std::numeric_limits<int>::max();
  for (const MapPatch& patch : {MapPatch{{3, 0}, 2, 1, {0, 0}},
                                {{0, 3}, 1, 1, {0}},
                                {{-1, 0}, 1, 1, {0}},
                                {{0, -1}, 1, 1, {0}},
                                {{0, 0}, 0, 0, {}},
                                {{0, 0}, -1, -1, {0}},
                                {{2, 2}, kMost, 1, {}},
                                {{kMost, kMost}, kMost, kMost, {}}}) {
    EXPECT_THAT(error(patch), testing::HasSubstr("all within the map's 4 x 3"));
  }
}

}  // namespace
}  // namespace adaptive_localization
