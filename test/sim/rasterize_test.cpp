// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rasterize.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adaptive_localization/map/map_io.hpp"
#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

TEST(Rasterize, KnowsFreeOccupiedAndUnknownInTheHall) {
  for (const double turn : {0.0, 0.1}) {
    const OccupancyGrid grid = rasterize(hall(), 0.05, turn);
    const auto at = [&](double x, double y) {
      return grid.cells()[grid.lattice().index(grid.lattice().cellAt({x, y}))];
    };
    EXPECT_EQ(at(0.1, 0.1), OccupancyGrid::kFree);
    EXPECT_EQ(at(0.0, 3.0), OccupancyGrid::kOccupied);
    EXPECT_EQ(at(-0.1, 3.0), OccupancyGrid::kUnknown);
    EXPECT_EQ(at(4.0, 2.5), OccupancyGrid::kOccupied);
    EXPECT_EQ(at(4.5, 2.5), OccupancyGrid::kUnknown);
    EXPECT_EQ(at(8.5, 0.1), OccupancyGrid::kFree) << "furniture is not in the map";
  }
  EXPECT_EQ(rasterize(hall(), 0.05).countFree(), 199U * 119U - 21U * 21U);
}

TEST(Rasterize, HasSurfacesInTheMiddleOfCellsWhereTheyLieOnMultiplesOfTheResolution) {
  for (const auto& name : kWorlds) {
    const FloorPlan plan = loadFloorPlan(worldFile(name));
    const auto world = makeWorld(plan, false);
    const OccupancyGrid grid = rasterize(plan, 0.05);
    int occupied = 0;
    int off = 0;
    for (std::size_t i = 0; i < grid.lattice().size(); ++i) {
      const Cell cell = grid.lattice().cell(i);
      if (!grid.isOccupied(cell)) continue;
      ++occupied;
      double nearest = 1.0;  // of points around the centre: within a wall there is no clearance
      for (const Cell& to : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}, Cell{1, 1},
                             Cell{-1, 1}, Cell{1, -1}, Cell{-1, -1}}) {
        const Eigen::Vector2d way = 1e-3 * Eigen::Vector2d(to.x, to.y);
        const double clearance = world->clearance(grid.lattice().centre(cell) + way, 1.0);
        if (clearance > 0.0) nearest = std::min(nearest, clearance);
      }
      if (nearest > 2e-3) ++off;
    }
    EXPECT_GT(occupied, 300) << name;
    const bool is_askew = name == "expansion" || name == "corridor";  // in part
    EXPECT_LE(off, is_askew ? 120 : 0) << name;
  }
}

TEST(Rasterize, OccupiesTheCellsInWhichBeamsEnd) {
  for (const auto& name : kWorlds) {
    const FloorPlan plan = loadFloorPlan(worldFile(name));
    const auto world = makeWorld(plan, false);
    const OccupancyGrid grid = rasterize(plan, 0.05, 0.1);
    Rng rng(3);
    int ends = 0;
    int missed = 0;
    while (ends < 1000) {
      const Bounds bounds = world->bounds();
      const Pose2 ray{rng.uniform(bounds.low.x(), bounds.high.x()),
                      rng.uniform(bounds.low.y(), bounds.high.y()), rng.uniform(-kPi, kPi)};
      const Cell start = grid.lattice().cellAt({ray.x, ray.y});
      if (world->clearance({ray.x, ray.y}, 1.0) < 0.1) continue;
      EXPECT_TRUE(grid.isFree(start)) << name;
      const double range = world->range(ray, 80.0);
      const Eigen::Vector2d end = ray * Eigen::Vector2d(range, 0.0);
      const Eigen::Vector2d before = ray * Eigen::Vector2d(range - 1e-6, 0.0);
      missed += !grid.isOccupied(grid.lattice().cellAt(end)) &&
                !grid.isOccupied(grid.lattice().cellAt(before));
      ++ends;
    }
    EXPECT_LE(missed, 5) << name << ": but for cells of which a surface cuts a corner";
  }
}

TEST(Rasterize, HasSurfacesInTheMiddleOfItsCellsOnTheAverageIfTurned) {
  const FloorPlan plan = hall();
  const OccupancyGrid grid = rasterize(plan, 0.05, 0.1);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < grid.lattice().size(); ++i) {
    const Eigen::Vector2d centre = grid.lattice().centre(grid.lattice().cell(i));
    const bool at_west_wall = std::abs(centre.x()) < 0.04 && centre.y() > 0.5 && centre.y() < 5.5;
    if (!at_west_wall || !grid.isOccupied(grid.lattice().cell(i))) continue;
    sum += centre.x();
    ++count;
  }
  EXPECT_GT(count, 90);
  EXPECT_NEAR(sum / count, 0.0, 0.003);
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
  for (const double resolution : {0.0, -0.05, 1e-6, std::nan("")}) {
    EXPECT_THROW(rasterize(hall(), resolution), std::invalid_argument) << resolution;
  }
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
  const OccupancyGrid grid = rasterize(loadFloorPlan(worldFile("corridor")), 0.05);
  EXPECT_NEAR(static_cast<double>(grid.countFree()) * 0.05 * 0.05, 750.0, 20.0);
}

}  // namespace
}  // namespace adaptive_localization
