// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/occupancy_grid.hpp"

#include <gmock/gmock.h>

#include <algorithm>
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

/// Cells by chance, most of them unknown.
std::vector<std::int8_t> mostlyUnknown(const Lattice& lattice, int known, Rng& rng) {
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
  for (int i = 0; i < known; ++i) {
    cells[rng.below(cells.size())] = static_cast<std::int8_t>(rng.below(101));
  }
  return cells;
}

void expectCells(const OccupancyGrid& grid, const std::vector<std::int8_t>& cells) {
  EXPECT_EQ(grid.cells(), cells);
  const Lattice& lattice = grid.lattice();
  const auto isKnown = [](std::int8_t value) { return value >= 0; };
  const auto known = std::count_if(cells.begin(), cells.end(), isKnown);
  EXPECT_EQ(grid.countKnown(), static_cast<std::size_t>(known));
  EXPECT_EQ(grid.knownCells().size(), grid.known().size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    ASSERT_EQ(grid.at(lattice.cell(i)), cells[i]) << i;
    if (cells[i] >= 0) {
      ASSERT_TRUE(grid.known().contains(lattice.cell(i))) << i;
    }
  }
}

bool isSmallest(const OccupancyGrid& grid) {
  const CellBox& box = grid.known();
  bool left = false, right = false, bottom = false, top = false;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (grid.knownCells()[i] < 0) continue;
    const Cell cell = box.cell(i);
    left = left || cell.x == box.x;
    right = right || cell.x == box.x + box.width - 1;
    bottom = bottom || cell.y == box.y;
    top = top || cell.y == box.y + box.height - 1;
  }
  return box.size() == 0 || (left && right && bottom && top);
}

TEST(OccupancyGrid, StoresTheSmallestBoxAroundWhatIsKnown) {
  Rng rng(5);
  for (const int known : {0, 1, 2, 3, 8, 200}) {
    for (int run = 0; run < 20; ++run) {
      const Lattice lattice(1 + static_cast<int>(rng.below(12)), 1 + static_cast<int>(rng.below(9)),
                            0.05, {});
      const std::vector<std::int8_t> cells = mostlyUnknown(lattice, known, rng);
      const OccupancyGrid grid(lattice, cells);
      expectCells(grid, cells);
      EXPECT_TRUE(isSmallest(grid));
      expectCells(OccupancyGrid::fromRows(lattice,
                                          [&](int row) {
                                            return cells.data() + lattice.index({0, row});
                                          }),
                  cells);
    }
  }
}

TEST(OccupancyGrid, PatchesMayMakeMoreKnownOrLess) {
  Rng rng(6);
  const Lattice lattice(12, 9, 0.05, {});
  for (int run = 0; run < 100; ++run) {
    std::vector<std::int8_t> cells = mostlyUnknown(lattice, static_cast<int>(rng.below(4)), rng);
    const OccupancyGrid grid(lattice, cells);
    std::vector<MapPatch> patches;
    for (int n = 0; n < 3; ++n) {
      MapPatch patch{{static_cast<int>(rng.below(12)), static_cast<int>(rng.below(9))}, 0, 0, {}};
      patch.width = 1 + static_cast<int>(rng.below(static_cast<std::size_t>(12 - patch.corner.x)));
      patch.height = 1 + static_cast<int>(rng.below(static_cast<std::size_t>(9 - patch.corner.y)));
      for (int i = 0; i < patch.width * patch.height; ++i) {
        const bool is_known = rng.uniform() < 0.2;
        patch.cells.push_back(is_known ? static_cast<std::int8_t>(rng.below(101))
                                       : std::int8_t{-1});
        cells[lattice.index({patch.corner.x + i % patch.width, patch.corner.y + i / patch.width})] =
            patch.cells.back();
      }
      patches.push_back(patch);
    }
    const OccupancyGrid other = grid.with(patches);
    expectCells(other, cells);
    EXPECT_TRUE(isSmallest(other));
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

TEST(OccupancyGrid, BeamsDoNotEndAtPairsOfSpeckleButAtWhatIsLarger) {
  const OccupancyGrid speckled = strewn(100, 1);
  const auto with = [&](const std::vector<Cell>& things) {
    std::vector<std::int8_t> cells = speckled.cells();
    for (int y = 37; y < 53; ++y) {  // room for them
      for (int x = 47; x < 63; ++x) cells[speckled.lattice().index({x, y})] = 0;
    }
    for (const Cell& thing : things) cells[speckled.lattice().index(thing)] = 100;
    return OccupancyGrid(speckled.lattice(), cells);
  };
  const OccupancyGrid pair = with({{52, 44}, {54, 45}});
  ASSERT_TRUE(pair.hasSpeckle());
  EXPECT_FALSE(pair.endsBeams({52, 44}));
  EXPECT_FALSE(pair.endsBeams({54, 45}));
  const OccupancyGrid three = with({{52, 44}, {53, 44}, {53, 45}});
  EXPECT_TRUE(three.endsBeams({52, 44}));
  EXPECT_TRUE(three.endsBeams({53, 45}));
  EXPECT_TRUE(speckled.endsBeams({0, 0})) << "the end of a wall";
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
