// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/occupancy_grid.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
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

/// A room of 10 m by 5 m, at a resolution of 0.05 m, with things of some cells' width here and
/// there.
OccupancyGrid strewn(int things, int width, double resolution = 0.05) {
  const Lattice lattice(200, 100, resolution, {});
  std::vector<std::int8_t> cells(lattice.size(), 0);
  for (int x = 0; x < 200; ++x) {
    cells[lattice.index({x, 0})] = cells[lattice.index({x, 99})] = OccupancyGrid::kOccupied;
  }
  Rng rng(1);
  for (int i = 0; i < things; ++i) {
    const Cell cell{5 + static_cast<int>(rng.below(185)), 5 + static_cast<int>(rng.below(85))};
    for (int dx = 0; dx < width; ++dx) {
      cells[lattice.index({cell.x + dx, cell.y})] = OccupancyGrid::kOccupied;
    }
  }
  return OccupancyGrid(lattice, cells);
}

TEST(OccupancyGrid, HasSpeckleWhereManyCellsAreIsolatedAndFewInPairs) {
  EXPECT_TRUE(strewn(100, 1).hasSpeckle());
  EXPECT_FALSE(strewn(100, 2).hasSpeckle()) << "pairs: legs of chairs, say";
  EXPECT_FALSE(strewn(5, 1).hasSpeckle()) << "posts";
  EXPECT_FALSE(strewn(100, 1, 0.2).hasSpeckle()) << "columns";
  EXPECT_FALSE(strewn(0, 1).hasSpeckle());
}

TEST(OccupancyGrid, SpeckleMayComeAndGoWithAnUpdate) {
  const OccupancyGrid speckled = strewn(100, 1), clean = strewn(0, 1);
  const auto patch = [](const OccupancyGrid& grid) {
    return MapPatch{{0, 0}, 200, 100, grid.cells()};
  };
  EXPECT_TRUE(clean.with({patch(speckled)}).hasSpeckle());
  EXPECT_FALSE(speckled.with({patch(clean)}).hasSpeckle());
}

TEST(OccupancyGrid, BeamsDoNotEndAtSpeckleButAtPosts) {
  const OccupancyGrid speckled = strewn(100, 1), with_posts = strewn(5, 1);
  std::size_t isolated = 0;
  for (std::size_t i = 0; i < speckled.lattice().size(); ++i) {
    const Cell cell = speckled.lattice().cell(i);
    isolated += speckled.isOccupied(cell) && !speckled.endsBeams(cell) ? 1 : 0;
    EXPECT_EQ(with_posts.endsBeams(cell), with_posts.isOccupied(cell));
  }
  EXPECT_GT(isolated, 80U);
  EXPECT_LE(isolated, 100U);
  EXPECT_TRUE(speckled.endsBeams({50, 0})) << "a wall";
}

TEST(OccupancyGrid, BeamsDoNotEndAtFreeCellsNorOutside) {
  const OccupancyGrid grid(Lattice(3, 1, 0.05, {}), {0, 100, 100});
  EXPECT_FALSE(grid.endsBeams({0, 0}));
  EXPECT_TRUE(grid.endsBeams({1, 0}));
  EXPECT_TRUE(grid.endsBeams({2, 0}));
  EXPECT_FALSE(grid.endsBeams({3, 0}));
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
