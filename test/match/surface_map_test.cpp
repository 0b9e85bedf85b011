// SPDX-License-Identifier: BSD-3-Clause
#include "match/surface_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// A straight wall across free ground, as a perfect survey would draw it: cells whose centres lie
/// beyond the line, but only the first.
std::shared_ptr<const OccupancyGrid> slopedWall(double angle, const Pose2& origin = {}) {
  const Lattice lattice(100, 100, 0.05, origin);
  std::vector<std::int8_t> cells(lattice.size());
  const auto beyond = [&](const Cell& cell) {
    const Eigen::Vector2d at =
        lattice.centre(cell) - Eigen::Vector2d(origin.x + 2.5, origin.y + 2.5);
    return std::sin(angle) * at.x() + std::cos(angle) * at.y();
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double depth = beyond(lattice.cell(i));
    cells[i] = depth < 0.0    ? OccupancyGrid::kFree
               : depth < 0.07 ? OccupancyGrid::kOccupied
                              : OccupancyGrid::kUnknown;
  }
  return std::make_shared<const OccupancyGrid>(lattice, std::move(cells));
}

TEST(SurfaceMap, KnowsASlopedWallBetterThanItsCells) {
  for (const double angle : {0.0, 0.1, 0.3, 0.6, 1.0}) {
    const SurfaceMap surfaces(*slopedWall(angle));
    const Eigen::Vector2d across(std::sin(angle), std::cos(angle));
    const Eigen::Vector2d along(across.y(), -across.x());
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (double way = -1.5; way <= 1.5; way += 0.01, ++count) {
      const Eigen::Vector2d at = Eigen::Vector2d(2.5, 2.5) + way * along;
      const Surface* surface = surfaces.hitBy(at - across, at);
      ASSERT_NE(surface, nullptr);
      const double turned = std::abs(surface->normal.cast<double>().dot(along));
      EXPECT_LT(turned, 0.2) << angle;  // 11 degrees
      EXPECT_LT(surface->normal.cast<double>().dot(across), 0.0) << "to the free side";
      EXPECT_FALSE(surface->has_two_sides);
      const double off = across.dot(surface->point - at);
      sum += off;
      squares += off * off;
    }
    const double mean = sum / count;
    EXPECT_LT(squares / count - mean * mean, 0.008 * 0.008) << angle;  // a cell's is 0.0144
    EXPECT_LT(std::abs(mean), 0.04) << angle;
  }
}

TEST(SurfaceMap, IsAsExactWhereCoordinatesAreThoseOfTheEarth) {
  const Pose2 origin{500000.0, 5000000.0, 0.0};
  const Eigen::Vector2d shift(origin.x, origin.y), start(2.5, 1.5), hit(2.5, 2.5);
  const SurfaceMap near(*slopedWall(0.3)), far(*slopedWall(0.3, origin));
  const Surface* here = near.hitBy(start, hit);
  const Surface* there = far.hitBy(shift + start, shift + hit);
  ASSERT_NE(here, nullptr);
  ASSERT_NE(there, nullptr);
  EXPECT_LT((there->point - shift - here->point).norm(), 1e-6);
}

TEST(SurfaceMap, TellsThinWallsFromThickOnes) {
  const SurfaceMap thin(*toyWorld({".....", "#####", "....."}, 0.05));
  for (const Eigen::Vector2d& start : {Eigen::Vector2d(0.1, -1.0), Eigen::Vector2d(0.1, 1.0)}) {
    const Surface* surface = thin.hitBy(start, {0.12, 0.07});
    ASSERT_NE(surface, nullptr);
    EXPECT_TRUE(surface->has_two_sides);
    EXPECT_TRUE(surface->faces(start));
  }
}

/// A board of 4 cm, thinner than a cell, and hits that noise puts behind it.
TEST(SurfaceMap, FindsTheSideThatABeamHit) {
  const std::vector<Segment> board{{{4.0, 1.0}, {0.0, 1.0}}, {{0.0, 1.04}, {4.0, 1.04}}};
  const SurfaceMap surfaces(Lattice(100, 60, 0.05, {-0.5, -0.5, 0.0}), board);
  const Eigen::Vector2d below(2.1, 0.2), above(1.9, 1.9);
  for (const double y : {0.93, 0.99, 1.01, 1.03, 1.05, 1.11}) {
    for (const Eigen::Vector2d& start : {below, above}) {
      const Surface* surface = surfaces.hitBy(start, {2.0, y});
      ASSERT_NE(surface, nullptr) << y;
      EXPECT_DOUBLE_EQ(surface->point.y(), start.y() < 1.0 ? 1.0 : 1.04) << y;
    }
  }
}

/// As many as have a number of 16 bits, and more.
TEST(SurfaceMap, TellsThousandsOfSurfacesApart) {
  constexpr int kRows = 220;
  for (const int columns : {297, 298, 310}) {
    std::vector<Segment> pieces;  // free space above each
    for (int i = 0; i < kRows * columns; ++i) {
      const Eigen::Vector2d a(0.1 * (i % columns) + 0.02, 0.1 * (i / columns) + 0.05);
      pieces.push_back({a, a + Eigen::Vector2d(0.06, 0.0)});
    }
    const SurfaceMap surfaces(Lattice(640, 460, 0.05, {}), pieces);
    ASSERT_EQ(surfaces.surfaces().size(), pieces.size());
    for (std::size_t i = 0; i < pieces.size(); i += 11) {
      const Eigen::Vector2d middle = (pieces[i].a + pieces[i].b) / 2.0;
      const Surface* surface = surfaces.hitBy(middle + Eigen::Vector2d(0.0, 0.04), middle);
      ASSERT_EQ(surface, &surfaces.surfaces()[i]) << i << " of " << pieces.size();
    }
  }
}

/// On a map of many tiles, the last of which it cuts off.
TEST(SurfaceMap, KnowsSurfacesWithinReachAndNoOthers) {
  const std::vector<Segment> walls{{{30.0, 0.53}, {0.5, 0.53}}, {{20.03, 19.0}, {20.03, 1.0}}};
  const SurfaceMap surfaces(Lattice(607, 391, 0.05, {}), walls, 1.0);
  for (double along = 0.6; along < 29.9; along += 0.13) {
    const Eigen::Vector2d start(along, 0.02);
    for (const double y : {0.4, 0.56, 1.4}) {
      EXPECT_EQ(surfaces.hitBy(start, {along, y}), &surfaces.surfaces()[0]) << along << ", " << y;
    }
    if (along > 18.8 && along < 21.2) continue;  // the other wall is near
    EXPECT_EQ(surfaces.hitBy(start, {along, 1.7}), nullptr) << along;
  }
  for (double along = 2.7; along < 18.9; along += 0.17) {
    const Eigen::Vector2d start(24.0, along);
    for (const double x : {20.1, 19.9, 19.2}) {
      EXPECT_EQ(surfaces.hitBy(start, {x, along}), &surfaces.surfaces()[1]) << along << ", " << x;
    }
    EXPECT_EQ(surfaces.hitBy(start, {18.8, along}), nullptr);
  }
}

TEST(SurfaceMap, HasNothingWhereThereIsNothing) {
  const SurfaceMap empty(*toyWorld({"....", "...."}, 0.05));
  EXPECT_TRUE(empty.surfaces().empty());
  EXPECT_EQ(empty.hitBy({0.0, 0.0}, {0.1, 0.05}), nullptr);
  const SurfaceMap wall(*slopedWall(0.0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double far = 1e30;
  for (const Eigen::Vector2d& odd :
       {Eigen::Vector2d(nan, 1.0), Eigen::Vector2d(far, -far), Eigen::Vector2d(2.5, -10.0)}) {
    EXPECT_EQ(wall.hitBy({2.0, 1.0}, odd), nullptr);
  }
}

}  // namespace
}  // namespace adaptive_localization
