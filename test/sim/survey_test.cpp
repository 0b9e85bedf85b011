// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/sim/survey.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

TEST(Survey, OccupiesTheCellsInWhichBeamsEnd) {
  for (const auto& name : kWorlds) {
    const FloorPlan plan = loadFloorPlan(worldFile(name));
    const auto world = makeWorld(plan, false);
    const OccupancyGrid grid = survey(plan, 0.05);
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

TEST(Survey, HasSurfacesInTheMiddleOfTheirCellsOnTheAverage) {
  const FloorPlan plan = hall();
  const OccupancyGrid grid = survey(plan, 0.05);
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

TEST(Survey, IsUnknownWithinWallsAndOutside) {
  const OccupancyGrid grid = survey(hall(), 0.05);
  const auto at = [&](double x, double y) {
    return grid.cells()[grid.lattice().index(grid.lattice().cellAt({x, y}))];
  };
  EXPECT_EQ(at(4.5, 2.5), OccupancyGrid::kUnknown);
  EXPECT_EQ(at(-0.15, 3.0), OccupancyGrid::kUnknown);
  EXPECT_EQ(at(8.5, 0.5), OccupancyGrid::kFree) << "no furniture";
}

TEST(Survey, NeedsAResolution) {
  EXPECT_THROW(survey(hall(), 0.0), std::invalid_argument);
  EXPECT_THROW(survey(hall(), -0.05), std::invalid_argument);
  EXPECT_THROW(survey(hall(), 1e-5), std::invalid_argument);
  EXPECT_THROW(survey(hall(), std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace adaptive_localization
