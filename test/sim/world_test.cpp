// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "adaptive_localization/core/rng.hpp"
#include "map/ray_caster.hpp"
#include "map/segment_index.hpp"
#include "sim/rasterize.hpp"
#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

std::vector<Segment> randomSegments(Rng& rng, int count) {
  std::vector<Segment> segments;
  for (int i = 0; i < count; ++i) {
    segments.push_back(
        {{rng.uniform(0, 30), rng.uniform(0, 20)}, {rng.uniform(0, 30), rng.uniform(0, 20)}});
  }
  return segments;
}

TEST(World, RangesInTheHallAreThoseOfGeometry) {
  const auto world = makeWorld(hall(), false);
  EXPECT_NEAR(world->range({1, 1, 0}, 80), 9.0, 1e-12);
  EXPECT_NEAR(world->range({1, 2.5, 0}, 80), 3.0, 1e-12);
  EXPECT_NEAR(world->range({1, 1, kPi / 2}, 80), 5.0, 1e-12);
  EXPECT_NEAR(world->range({1, 1, -3 * kPi / 4}, 80), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(world->range({6, 1.5, 3 * kPi / 4}, 80), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(world->range({1, 1, 0}, 5), 5.0);
}

TEST(World, FurnitureIsThereOnlyIfAskedFor) {
  EXPECT_NEAR(makeWorld(hall(), true)->range({7, 0.5, 0}, 80), 1.0, 1e-12);
  EXPECT_NEAR(makeWorld(hall(), false)->range({7, 0.5, 0}, 80), 3.0, 1e-12);
}

TEST(World, ClearanceIsTheDistanceToTheNearestSurfaceAndZeroInside) {
  const auto world = makeWorld(hall(), false);
  EXPECT_NEAR(world->clearance({1, 2}, 5), 1.0, 1e-12);
  EXPECT_NEAR(world->clearance({3, 1}, 5), 1.0, 1e-12);
  EXPECT_NEAR(world->clearance({3.4, 1.2}, 5), 1.0, 1e-12);  // the column's corner
  EXPECT_EQ(world->clearance({1, 2}, 0.3), 0.3);
  EXPECT_EQ(world->clearance({4.5, 2.5}, 5), 0.0);
  EXPECT_EQ(world->clearance({-1, 2.5}, 5), 0.0);
}

TEST(World, BinsChangeNothingInRangesAndDistances) {
  Rng rng(1);
  const auto segments = randomSegments(rng, 60);
  const SegmentIndex index(segments);
  for (int i = 0; i < 3000; ++i) {
    const Pose2 ray{rng.uniform(-5, 35), rng.uniform(-5, 25), rng.uniform(-kPi, kPi)};
    const Eigen::Vector2d start(ray.x, ray.y);
    double range = 12.0;
    double nearest = 3.0;
    for (const auto& segment : segments) {
      range = std::min(range, hit(segment, start, {std::cos(ray.theta), std::sin(ray.theta)}));
      nearest = std::min(nearest, distance(segment, start));
    }
    ASSERT_EQ(index.range(ray, 12.0), range) << "ray " << i;
    ASSERT_EQ(index.distance(start, 3.0), nearest) << "point " << i;
  }
}

TEST(World, NoRayLeavesThroughACorner) {
  const SegmentIndex index(
      {{{0, 0}, {3, 0}}, {{3, 0}, {3, 2}}, {{3, 2}, {0, 2}}, {{0, 2}, {0, 0}}});
  const Eigen::Vector2d corners[] = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
  Rng rng(2);
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector2d start(rng.uniform(0.1, 2.9), rng.uniform(0.1, 1.9));
    const Eigen::Vector2d way = corners[i % 4] - start;
    const double range = index.range({start.x(), start.y(), std::atan2(way.y(), way.x())}, 80);
    ASSERT_NEAR(range, way.norm(), 1e-6);
  }
}

TEST(World, AMapTakenForTheTruthHasTheMapsRanges) {
  const auto grid = std::make_shared<const OccupancyGrid>(rasterize(hall(), 0.05));
  const auto world = makeWorld(grid);
  const RayCaster caster(grid);
  Rng rng(3);
  for (int i = 0; i < 200; ++i) {
    const Pose2 ray{rng.uniform(0.1, 3.9), rng.uniform(0.1, 5.9), rng.uniform(-kPi, kPi)};
    ASSERT_EQ(world->range(ray, 80), caster.range(ray, 80));
    ASSERT_NEAR(world->clearance({ray.x, ray.y}, 0.5),
                makeWorld(hall(), false)->clearance({ray.x, ray.y}, 0.5), 0.06);
  }
  EXPECT_EQ(world->clearance({-50, 0}, 1), 0.0);
}

/// However deep it is: a robot is not put down on it, and finds no way across.
TEST(World, WhatAMapDoesNotShowIsSolid) {
  const Lattice lattice(120, 80, 0.05, {});
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = lattice.cell(i);
    const bool is_room = cell.x >= 10 && cell.x < 50 && cell.y >= 10 && cell.y < 50;
    if (is_room) cells[i] = OccupancyGrid::kFree;
  }
  const auto world = makeWorld(std::make_shared<const OccupancyGrid>(lattice, std::move(cells)));
  EXPECT_EQ(world->clearance({4.5, 2.0}, 1.0), 0.0) << "2 m from the room";
  EXPECT_NEAR(world->clearance({1.5, 1.5}, 2.0), 1.0, 0.06);
  const FreeSpace space(world, 0.2);
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d place = space.sample(rng);
    EXPECT_TRUE(place.x() > 0.5 && place.x() < 2.5 && place.y() > 0.5 && place.y() < 2.5)
        << place.transpose();
  }
}

TEST(World, AMapWithoutFreeGroundHasNoPlaceForARobot) {
  for (const std::int8_t value : {OccupancyGrid::kUnknown, OccupancyGrid::kOccupied}) {
    const auto grid = std::make_shared<const OccupancyGrid>(Lattice(80, 80, 0.05, {}),
                                                            std::vector<std::int8_t>(6400, value));
    EXPECT_THROW(FreeSpace(makeWorld(grid), 0.2), std::invalid_argument);
  }
}

TEST(World, TruthAndMapAgreeInEveryWorld) {
  for (const auto& name : kWorlds) {
    const FloorPlan plan = loadFloorPlan(worldFile(name));
    const auto world = makeWorld(plan, false);
    const auto grid = std::make_shared<const OccupancyGrid>(rasterize(plan, 0.05));
    const RayCaster caster(grid);
    const FreeSpace space(world, 0.1);
    Rng rng(4);
    int far_off = 0;
    constexpr int kRays = 4000;
    for (int i = 0; i < kRays; ++i) {
      const Eigen::Vector2d place = space.sample(rng);
      const Pose2 ray{place.x(), place.y(), rng.uniform(-kPi, kPi)};
      // Along a wall and past an edge the ranges differ by more than two cells, but rarely.
      if (std::abs(world->range(ray, 80) - caster.range(ray, 80)) > 0.1) ++far_off;
    }
    EXPECT_LT(far_off, kRays / 20) << name;
  }
}

TEST(Site, KnowsAPlanFromAMapAndNamesWhatIsNeither) {
  EXPECT_TRUE(loadSite(worldFile("maze"), false).start.has_value());
  const Site map = loadSite(mapFile("maze"), false);
  EXPECT_TRUE(map.route.empty());
  EXPECT_FALSE(map.start.has_value());
  try {
    loadSite("/no/such/world.yaml", false);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'/no/such/world.yaml'"));
  }
}

}  // namespace
}  // namespace adaptive_localization
