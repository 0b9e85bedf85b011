// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/distance_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "support/random_grid.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// Ends beams, and is no deeper than 0.35 m below the nearest cell that does not.
bool isWall(const OccupancyGrid& grid, const Cell& cell) {
  if (!grid.endsBeams(cell)) return false;
  const double deepest = 1.0 + 0.35 / grid.lattice().resolution();  // cells
  const int reach = static_cast<int>(deepest);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const bool is_near = std::hypot(dx, dy) <= deepest;
      if (is_near && !grid.endsBeams({cell.x + dx, cell.y + dy})) return true;
    }
  }
  return false;
}

double bruteForce(const OccupancyGrid& grid, const Cell& from) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < grid.lattice().size(); ++i) {
    const Cell cell = grid.lattice().cell(i);
    if (isWall(grid, cell)) {
      nearest = std::min(nearest, std::hypot(cell.x - from.x, cell.y - from.y));
    }
  }
  return nearest * grid.lattice().resolution();
}

TEST(DistanceField, IsTheBruteForceDistanceOnRandomGrids) {
  Rng rng(1);
  for (int trial = 0; trial < 40; ++trial) {
    const Lattice lattice(1 + static_cast<int>(rng.below(40)), 1 + static_cast<int>(rng.below(30)),
                          rng.uniform(0.02, 0.5), {1.0, 2.0, 0.5});
    const auto grid = randomGrid(rng, lattice, trial % 2 == 0 ? 0.02 : 0.8);
    const DistanceField field(*grid);
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      const double expected = bruteForce(*grid, lattice.cell(i));
      if (expected > 1e6) continue;  // no obstacle at all
      ASSERT_NEAR(field.at(lattice.cell(i)), std::min(expected, field.reach()),
                  0.51 * field.metresPerStep());
    }
  }
}

TEST(DistanceField, WallsHaveADepthAndRockHasNone) {
  const Art art{".......", ".#####.", ".#####.", ".#####.", ".#####.", ".#####.", "......."};
  const DistanceField walls(*toyWorld(art, 0.1));
  for (const Cell& cell : {Cell{1, 1}, {2, 2}, {3, 3}}) EXPECT_EQ(walls.at(cell), 0.0);
  EXPECT_EQ(walls.at(Cell{0, 2}), 0.1 * 64 / 64);
  const DistanceField rock(*toyWorld(art, 0.3));
  EXPECT_EQ(rock.at(Cell{2, 2}), 0.0);
  EXPECT_NEAR(rock.at(Cell{3, 3}), 0.3, 0.01);
}

TEST(DistanceField, IsAtItsReachWithoutObstaclesAndOutside) {
  const DistanceField empty(*toyWorld({"..", ".?"}, 0.1));
  EXPECT_DOUBLE_EQ(empty.reach(), 5.0);
  EXPECT_DOUBLE_EQ(empty.at(Cell{1, 1}), 5.0);
  const DistanceField full(*toyWorld({"##", "##"}, 0.1));
  EXPECT_EQ(full.at(Cell{1, 1}), 0.0);
  EXPECT_DOUBLE_EQ(full.at(Cell{2, 1}), 5.0);
  EXPECT_DOUBLE_EQ(full.at(Eigen::Vector2d(std::nan(""), 0.0)), 5.0);
}

TEST(DistanceField, ReachesSixteenCellsOfCoarseMapsAndAThousandOfFineOnes) {
  for (const auto& [resolution, reach] : {std::pair{1.0, 16.0}, {0.001, 1.023}}) {
    std::vector<std::int8_t> cells(3000, OccupancyGrid::kFree);
    cells[0] = OccupancyGrid::kOccupied;
    const DistanceField field(OccupancyGrid(Lattice(3000, 1, resolution, {}), cells));
    EXPECT_DOUBLE_EQ(field.reach(), reach);
    EXPECT_DOUBLE_EQ(field.at(Cell{15, 0}), 15 * resolution);
    EXPECT_DOUBLE_EQ(field.at(Cell{2999, 0}), reach);
  }
}

/// Blocks, and tiles within them, are made for themselves.
TEST(DistanceField, IsTheSameAcrossBlocks) {
  Rng rng(2);
  const Lattice lattice(1100, 530, 0.25, {});  // reaches 20 cells
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kFree);
  std::vector<Cell> walls;
  for (int i = 0; i < 300; ++i) {
    walls.push_back({static_cast<int>(rng.below(1100)), static_cast<int>(rng.below(530))});
    cells[lattice.index(walls.back())] = OccupancyGrid::kOccupied;
  }
  const DistanceField field(OccupancyGrid(lattice, std::move(cells)));
  int near = 0;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const Cell cell = lattice.cell(i);
    double nearest = 20.0;
    for (const Cell& wall : walls) {
      nearest = std::min(nearest, std::hypot(wall.x - cell.x, wall.y - cell.y));
    }
    ASSERT_NEAR(field.cellsTo(cell), nearest, 0.51 / 64.0) << cell.x << ", " << cell.y;
    near += nearest < 20.0 ? 1 : 0;
  }
  EXPECT_GT(near, 200000);
}

TEST(DistanceField, IsLookedUpByPointsOfATurnedMap) {
  const auto map = toyWorld({"...", "...", "#.."}, 1.0, {5.0, 5.0, kPi / 2});
  const DistanceField field(*map);
  EXPECT_DOUBLE_EQ(field.at(Eigen::Vector2d(4.5, 5.5)), 0.0);  // the cell at the origin
  EXPECT_DOUBLE_EQ(field.at(Eigen::Vector2d(4.5, 7.5)), 2.0);  // two columns on
}

TEST(DistanceField, RunsStraightBetweenTheCentresOfCells) {
  const DistanceField field(*toyWorld({"....#"}, 0.5, {1.0, 2.0, 0.7}));
  const Lattice& lattice = field.lattice();
  const auto towards = [&](double share) -> Eigen::Vector2d {
    return (1.0 - share) * lattice.centre({1, 0}) + share * lattice.centre({2, 0});
  };
  EXPECT_NEAR(field.between(towards(0.0)), 1.5, 1e-9);
  EXPECT_NEAR(field.between(towards(0.25)), 1.375, 1e-9);
  EXPECT_NEAR(field.between(towards(1.0)), 1.0, 1e-9);
  EXPECT_NEAR(field.between(lattice.centre({4, 0})), 0.0, 1e-9);
  for (const double share : {0.499, 0.501}) {  // where the nearest cell changes
    EXPECT_NEAR(field.between(towards(share)), 1.5 - 0.5 * share, 1e-9) << share;
  }
  EXPECT_DOUBLE_EQ(field.between({-50.0, 0.0}), field.reach()) << "outside";
  EXPECT_DOUBLE_EQ(field.between({std::nan(""), 0.0}), field.reach());
}

std::shared_ptr<const OccupancyGrid> wallWithSpeckle(int speckle) {
  std::vector<std::int8_t> cells(200 * 20, OccupancyGrid::kFree);
  std::fill_n(cells.begin(), 200, OccupancyGrid::kOccupied);
  for (int i = 0; i < speckle; ++i) {
    cells[static_cast<std::size_t>(200 * 15 + 7 * i)] = OccupancyGrid::kOccupied;
  }
  return std::make_shared<const OccupancyGrid>(Lattice(200, 20, 0.05, {}), cells);
}

TEST(DistanceField, SpeckleIsNoWall) {
  const auto grid = wallWithSpeckle(20);
  ASSERT_TRUE(grid->hasSpeckle());
  EXPECT_NEAR(DistanceField(*grid).at(Cell{70, 15}), 15 * 0.05, 1e-9);
  const auto with_few = wallWithSpeckle(5);
  ASSERT_FALSE(with_few->hasSpeckle());
  EXPECT_EQ(DistanceField(*with_few).at(Cell{7, 15}), 0.0);
}

TEST(DistanceField, IsMadeAnewEverywhereWhereSpeckleAppears) {
  const auto few = wallWithSpeckle(10);
  ASSERT_FALSE(few->hasSpeckle());
  MapPatch patch{{100, 15}, 29, 1, std::vector<std::int8_t>(29, OccupancyGrid::kFree)};
  for (const std::size_t x : {0U, 7U, 14U, 21U, 28U}) patch.cells[x] = OccupancyGrid::kOccupied;
  const OccupancyGrid many = few->with({patch});
  ASSERT_TRUE(many.hasSpeckle());
  const DistanceField before(*few), after(many, before, {patch});
  EXPECT_EQ(before.at(Cell{0, 15}), 0.0);
  EXPECT_NEAR(after.at(Cell{0, 15}), 15 * 0.05, 1e-9);
}

/// Patches anywhere, with walls that come and go and rock: cells deeper than walls are.
TEST(DistanceField, MadeAnewNearPatchesIsTheOneOfTheWholeMap) {
  Rng rng(3);
  const auto below = [&](int limit) {
    return static_cast<int>(rng.below(static_cast<std::size_t>(limit)));
  };
  int changed = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Lattice lattice(1 + below(900), 1 + below(700), rng.uniform(0.1, 0.5), {});
    const auto before = randomGrid(rng, lattice, trial % 3 == 0 ? 0.0 : 0.001);
    std::vector<MapPatch> patches;
    for (int i = below(3); i >= 0; --i) {
      const Cell corner{below(lattice.width()), below(lattice.height())};
      MapPatch patch{corner,
                     1 + below(std::min(40, lattice.width() - corner.x)),
                     1 + below(std::min(40, lattice.height() - corner.y)),
                     {}};
      patch.cells.resize(static_cast<std::size_t>(patch.width * patch.height),
                         rng.uniform() < 0.5 ? OccupancyGrid::kOccupied : OccupancyGrid::kFree);
      patches.push_back(std::move(patch));
    }
    const OccupancyGrid after = before->with(patches);
    const DistanceField old(*before), expected(after), field(after, old, patches);
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      const Cell cell = lattice.cell(i);
      ASSERT_EQ(field.stepsTo(cell), expected.stepsTo(cell))
          << trial << ": " << cell.x << ", " << cell.y;
      changed += field.stepsTo(cell) != old.stepsTo(cell) ? 1 : 0;
    }
    EXPECT_EQ(field.quality().wallDepth(), expected.quality().wallDepth());
  }
  EXPECT_GT(changed, 10000);
}

}  // namespace
}  // namespace adaptive_localization
