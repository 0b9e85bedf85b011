// SPDX-License-Identifier: BSD-3-Clause
#include "map/ray_caster.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "support/pose_matchers.hpp"
#include "support/random_grid.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// Where a ray enters the square of a cell, by the slab method in the lattice's frame; infinite if
/// it does not. A ray that only grazes the square by less than `graze` does not enter it.
double entry(const Lattice& lattice, const Cell& cell, const Pose2& T_map_ray, double graze) {
  const Pose2 ray = lattice.toLattice(T_map_ray);
  const double size = lattice.resolution();
  double in = 0.0, out = std::numeric_limits<double>::infinity();
  const std::array<std::array<double, 3>, 2> axes{
      {{ray.x, std::cos(ray.theta), cell.x * size}, {ray.y, std::sin(ray.theta), cell.y * size}}};
  for (const auto& [start, direction, low] : axes) {
    const double a = (low - start) / direction;
    const double b = (low + size - start) / direction;
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return out - in > graze ? in : std::numeric_limits<double>::infinity();
}

double bruteForce(const OccupancyGrid& grid, const Pose2& ray, double max_range, double graze) {
  const double theta = grid.lattice().toLattice(ray).theta;
  const double inside = 0.5 * grid.lattice().resolution() /
                        std::max(std::abs(std::cos(theta)), std::abs(std::sin(theta)));
  double nearest = max_range;
  for (std::size_t i = 0; i < grid.lattice().size(); ++i) {
    const Cell cell = grid.lattice().cell(i);
    if (!grid.endsBeams(cell)) continue;
    nearest = std::min(nearest, entry(grid.lattice(), cell, ray, graze) + inside);
  }
  return nearest;
}

TEST(RayCaster, GoesOnThroughSpeckle) {
  std::vector<std::int8_t> cells(80, 0);
  for (std::size_t i = 5; i < 70; i += 5) cells[i] = OccupancyGrid::kOccupied;
  for (std::size_t i = 75; i < 78; ++i) cells[i] = OccupancyGrid::kOccupied;
  const auto grid = std::make_shared<const OccupancyGrid>(Lattice(80, 1, 0.05, {}), cells);
  ASSERT_TRUE(grid->hasSpeckle());
  const auto field = std::make_shared<const DistanceField>(*grid);
  EXPECT_NEAR(RayCaster(grid).range({0.025, 0.025, 0.0}, 5.0), 75 * 0.05, 1e-9);
  EXPECT_NEAR(RayCaster(grid, field).range({0.025, 0.025, 0.0}, 5.0), 75 * 0.05, 1e-9);
}

TEST(RayCaster, FindsTheFirstCellThatTheRayEnters) {
  Rng rng(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Lattice lattice(25, 15, rng.uniform(0.05, 0.5), randomPose(rng, 5.0));
    const auto grid = randomGrid(rng, lattice, 0.05);
    const RayCaster caster(grid);
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector2d middle = lattice.centre({12, 7});
      Pose2 ray = randomPose(rng, 20.0 * lattice.resolution());  // inside and outside
      ray.x += middle.x();
      ray.y += middle.y();
      const double range = caster.range(ray, 15.0);
      // at a corner that is grazed, rounding may decide either way
      const double with = bruteForce(*grid, ray, 15.0, -1e-6);
      const double without = bruteForce(*grid, ray, 15.0, 1e-6);
      ASSERT_TRUE(std::abs(range - with) < 1e-6 || std::abs(range - without) < 1e-6)
          << range << " instead of " << without << " from " << testing::PrintToString(ray);
    }
  }
}

TEST(RayCaster, FindsTheSameWallsByTheDistanceField) {
  Rng rng(2);
  for (int trial = 0; trial < 50; ++trial) {
    const Lattice lattice(120, 80, rng.uniform(0.05, 0.2), randomPose(rng, 5.0));
    const auto grid = randomGrid(rng, lattice, trial % 2 == 0 ? 0.002 : 0.05);
    const RayCaster plain(grid), quick(grid, std::make_shared<const DistanceField>(*grid));
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector2d middle = lattice.centre({60, 40});
      Pose2 ray = randomPose(rng, 60.0 * lattice.resolution());  // inside and outside
      ray.x += middle.x();
      ray.y += middle.y();
      for (const double depth : {0.0, 0.35}) {
        const RayCaster::Wall expected = plain.wall(ray, 20.0, depth);
        const RayCaster::Wall wall = quick.wall(ray, 20.0, depth);
        EXPECT_NEAR(wall.near, expected.near, 1e-9);
        EXPECT_NEAR(wall.far, expected.far, 1e-9);
      }
    }
  }
}

TEST(RayCaster, FollowsAWallNoFartherThanIsAskedFor) {
  const auto map = toyWorld({"..######.."}, 0.1);
  const RayCaster caster(map);
  const Pose2 ray{0.05, 0.05, 0.0};
  for (int cell = 0; cell < 6; ++cell) {
    const double middle = 0.2 + 0.1 * cell;
    EXPECT_NEAR(caster.wall(ray, 9.0, 2.0, middle - 0.01).far, middle, 1e-9);
  }
  EXPECT_NEAR(caster.wall(ray, 9.0, 2.0, 0.05).far, 0.2, 1e-9);
  EXPECT_NEAR(caster.wall(ray, 9.0, 2.0, 5.0).far, 0.7, 1e-9);
  EXPECT_NEAR(caster.wall(ray, 9.0, 0.25, 5.0).far, 0.4, 1e-9) << "nor deeper";
}

TEST(RayCaster, BeginsDeepInRock) {
  const auto map = toyWorld(Art(40, std::string(40, '#')), 0.1);
  const RayCaster plain(map), quick(map, std::make_shared<const DistanceField>(*map));
  const Pose2 ray{2.03, 2.01, 0.4};
  EXPECT_LT(quick.range(ray, 9.0), 0.1);
  EXPECT_DOUBLE_EQ(quick.range(ray, 9.0), plain.range(ray, 9.0));
  EXPECT_DOUBLE_EQ(quick.wall(ray, 9.0, 0.5).far, plain.wall(ray, 9.0, 0.5).far);
}

TEST(RayCaster, IsExactAlongTheAxes) {
  const auto map = toyWorld({"#####", "#...#", "#...#", "#...#", "#####"}, 1.0);
  const RayCaster caster(map);
  EXPECT_DOUBLE_EQ(caster.range({2.25, 2.75, 0.0}, 9.0), 2.25);
  EXPECT_NEAR(caster.range({2.25, 2.75, kPi}, 9.0), 1.75, 1e-12);
  EXPECT_NEAR(caster.range({2.25, 2.75, kPi / 2}, 9.0), 1.75, 1e-12);
  EXPECT_NEAR(caster.range({2.25, 2.75, -kPi / 2}, 9.0), 2.25, 1e-12);
}

TEST(RayCaster, DoesNotSlipThroughADiagonalWall) {
  const auto map = toyWorld({"...#", "..#.", ".#..", "#..."}, 1.0);
  const RayCaster caster(map);
  for (double y = 0.05; y < 3.0; y += 0.1) {
    EXPECT_LT(caster.range({3.9, y, 3.0 * kPi / 4 + 0.01}, 9.0), 9.0) << y;
  }
}

TEST(RayCaster, SeesTheMiddleOfTheWallsCellAndNothingBeyondTheRange) {
  const auto map = toyWorld({"....#"}, 1.0);
  const RayCaster caster(map);
  EXPECT_DOUBLE_EQ(caster.range({0.5, 0.5, 0.0}, 9.0), 4.0);
  EXPECT_DOUBLE_EQ(caster.range({0.5, 0.5, 0.0}, 3.9), 3.9);
  EXPECT_DOUBLE_EQ(caster.range({4.5, 0.5, 0.0}, 9.0), 0.5);  // inside the wall
}

TEST(RayCaster, SeesThroughTheUnknownAndFromOutside) {
  const auto map = toyWorld({"??#"}, 1.0);
  const RayCaster caster(map);
  EXPECT_DOUBLE_EQ(caster.range({0.5, 0.5, 0.0}, 9.0), 2.0);
  EXPECT_NEAR(caster.range({-3.0, 0.5, 0.0}, 9.0), 5.5, 1e-6);
  EXPECT_NEAR(caster.range({2.5, 4.0, -kPi / 2}, 9.0), 3.5, 1e-6);
  EXPECT_DOUBLE_EQ(caster.range({-3.0, 0.5, kPi}, 9.0), 9.0);
  EXPECT_DOUBLE_EQ(caster.range({-3.0, 5.0, 0.0}, 9.0), 9.0);
}

TEST(RayCaster, GivesTheSameRangesInATurnedMap) {
  Rng rng(2);
  const Pose2 origin{-3.0, 7.0, 2.1};
  const auto straight = asymmetricWorld();
  const auto turned = asymmetricWorld(origin);
  int equal = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose2 ray{rng.uniform(0.0, 10.0), rng.uniform(0.0, 5.0), rng.uniform(-kPi, kPi)};
    const double a = RayCaster(straight).range(ray, 20.0);
    const double b = RayCaster(turned).range(origin * ray, 20.0);
    equal += std::abs(a - b) < 1e-6 ? 1 : 0;
  }
  EXPECT_GE(equal, 498);  // a grazed corner may fall either way
}

TEST(RayCaster, EndsWhateverItIsGiven) {
  const RayCaster caster(asymmetricWorld());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1e300, -1e300}) {
    EXPECT_EQ(caster.range({bad, 1.0, 0.1}, 5.0), 5.0) << bad;
    EXPECT_EQ(caster.range({1.0, bad, 0.1}, 5.0), 5.0) << bad;
    EXPECT_GE(caster.range({1.0, 1.0, bad}, 5.0), 0.0) << bad;
    EXPECT_LE(caster.range({1.0, 1.0, bad}, 5.0), 5.0) << bad;
  }
  EXPECT_LT(caster.range({1.0, 1.0, 0.1}, inf), 20.0);
  EXPECT_EQ(caster.range({-1.0, -1.0, kPi}, inf), inf);
}

}  // namespace
}  // namespace adaptive_localization
