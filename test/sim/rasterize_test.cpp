// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/sim/rasterize.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "adaptive_localization/map/map_io.hpp"
#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

TEST(Rasterize, KnowsFreeOccupiedAndUnknownInTheHall) {
  const OccupancyGrid grid = rasterize(hall(), 0.05);
  const auto at = [&](double x, double y) {
    return grid.cells()[grid.lattice().index(grid.lattice().cellAt({x, y}))];
  };
  EXPECT_EQ(at(0.01, 0.01), OccupancyGrid::kFree);
  EXPECT_EQ(at(-0.01, 3.0), OccupancyGrid::kOccupied);
  EXPECT_EQ(at(-0.06, 3.0), OccupancyGrid::kUnknown);
  EXPECT_EQ(at(4.01, 2.5), OccupancyGrid::kOccupied);
  EXPECT_EQ(at(4.5, 2.5), OccupancyGrid::kUnknown);
  EXPECT_EQ(at(8.5, 0.01), OccupancyGrid::kFree);  // furniture is not in the map
  EXPECT_EQ(grid.countFree(), 200U * 120U - 20U * 20U);
}

TEST(Rasterize, SurfacesLieWithinHalfACellOfThePlan) {
  for (const auto& name : kWorlds) {
    const FloorPlan plan = loadFloorPlan(worldFile(name));
    const auto world = makeWorld(plan, false);
    const OccupancyGrid grid = rasterize(plan, 0.05);
    const Lattice& lattice = grid.lattice();
    int surfaces = 0;
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      const Cell cell = lattice.cell(i);
      if (!grid.isFree(cell)) continue;
      for (const Cell& next : {Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y + 1}}) {
        ASSERT_TRUE(grid.isFree(next) || grid.isOccupied(next)) << name << ": free beside unknown";
        if (!grid.isOccupied(next)) continue;
        const Eigen::Vector2d border = (lattice.centre(cell) + lattice.centre(next)) / 2.0;
        ASSERT_LE(world->clearance(border, 1.0), 0.025 + 1e-9) << name << " " << border.transpose();
        ++surfaces;
      }
    }
    EXPECT_GT(surfaces, 300) << name;
  }
}

TEST(Rasterize, NoWallIsLostInACoarseGrid) {
  const FloorPlan plan = loadFloorPlan(worldFile("maze"));
  for (const double resolution : {0.1, 0.15, 0.2, 0.25}) {
    const OccupancyGrid grid = rasterize(plan, resolution);
    for (const auto& wall : plan.walls) {
      const Eigen::Vector2d middle = (wall.a + wall.b) / 2.0;
      EXPECT_TRUE(grid.isOccupied(grid.lattice().cellAt(middle))) << resolution;
    }
  }
}

TEST(Rasterize, RefusesAResolutionThatMakesNoMap) {
  EXPECT_THROW(rasterize(hall(), 0.0), std::invalid_argument);
  EXPECT_THROW(rasterize(hall(), 1e-6), std::invalid_argument);
}

TEST(Maps, AreThoseThatTheirPlansMake) {
  for (const auto& name : kWorlds) {
    const OccupancyGrid committed = loadMap(mapFile(name));
    const OccupancyGrid drawn = rasterize(loadFloorPlan(worldFile(name)), 0.05);
    EXPECT_EQ(committed.cells(), drawn.cells()) << name;
    EXPECT_NEAR(committed.lattice().origin().x, drawn.lattice().origin().x, 1e-9) << name;
    EXPECT_NEAR(committed.lattice().origin().y, drawn.lattice().origin().y, 1e-9) << name;
  }
}

TEST(Maps, TheSymmetricOneLooksTheSameAfterHalfATurn) {
  auto cells = loadMap(mapFile("symmetric")).cells();
  const auto turned = cells;
  std::reverse(cells.begin(), cells.end());
  EXPECT_EQ(cells, turned);
}

TEST(Maps, TheCorridorsBuildingIsLarge) {
  const OccupancyGrid grid = rasterize(loadFloorPlan(worldFile("corridor")), 0.15);
  EXPECT_NEAR(static_cast<double>(grid.countFree()) * 0.15 * 0.15, 750.0, 20.0);
}

}  // namespace
}  // namespace adaptive_localization
