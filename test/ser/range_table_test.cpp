// SPDX-License-Identifier: BSD-3-Clause
#include "ser/range_table.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "adaptive_localization/map/distance_field.hpp"
#include "core/parallel.hpp"
#include "ser_toys.hpp"
#include "support/random_grid.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

double rangeIn(const RangeTable& table, std::size_t i, int direction) {
  return table.ranges(i)[direction] * table.metresPerStep();
}

/// By exact traversal of the grid.
double exactRange(const MapPtr& map, const RangeTable& table, std::size_t i, int direction) {
  const Eigen::Vector2d centre = table.centre(i);
  const double theta = table.lattice().origin().theta + direction * kDirectionStep;
  return RayCaster(map).range({centre.x(), centre.y(), theta}, table.maxRange());
}

/// Errors against exact traversal, in cells, ascending.
std::vector<double> errorsOf(const MapPtr& map, const RangeTable& table, int samples) {
  Rng rng(1);
  std::vector<double> errors;
  for (int n = 0; n < samples; ++n) {
    const std::size_t i = rng.below(table.size());
    const int direction = static_cast<int>(rng.below(kDirections));
    const double off = rangeIn(table, i, direction) - exactRange(map, table, i, direction);
    errors.push_back(std::abs(off) / map->lattice().resolution());
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

bool haveSameBytes(const RangeTable& a, const RangeTable& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::memcmp(a.ranges(i), b.ranges(i), kRangeStride) != 0) return false;
  }
  return true;
}

TEST(RangeTable, IsExactRayCastingForMostPosesOfTheMaze) {
  for (const double resolution : {0.05, 0.1, 0.25}) {
    const MapPtr map = maze(resolution);
    const RangeTable table(*map, 10.0);
    EXPECT_EQ(table.size(), map->countFree());
    const auto errors = errorsOf(map, table, 20000);
    EXPECT_LE(errors[errors.size() / 2], 0.3) << resolution;
    EXPECT_LE(errors[errors.size() * 98 / 100], 1.0) << resolution;
  }
}

TEST(RangeTable, IsExactRayCastingInClutter) {
  Rng rng(2);
  for (const double occupied : {0.01, 0.05, 0.2}) {
    const MapPtr map = randomGrid(rng, Lattice(70, 50, 0.1, {1.0, -2.0, 0.6}), occupied);
    const auto errors = errorsOf(map, RangeTable(*map, 6.0), 5000);
    EXPECT_LE(errors[errors.size() / 2], 0.6) << occupied;
  }
}

/// A closed curve of cells that touch by corners, as a scanner draws slanted walls.
MapPtr slantedRing(Rng& rng, int side) {
  std::vector<std::int8_t> cells(static_cast<std::size_t>(side * side), OccupancyGrid::kFree);
  const double radius = 0.3 * side;
  const double turned = rng.uniform(0.0, 2.0 * kPi);
  const int corners = 3 + static_cast<int>(rng.below(5));
  const auto corner = [&](int k) {
    const double angle = turned + 2.0 * kPi * k / corners;
    return Eigen::Vector2d(0.5 * side + radius * std::cos(angle),
                           0.5 * side + radius * std::sin(angle));
  };
  for (int k = 0; k < corners; ++k) {
    const Eigen::Vector2d a = corner(k).array().floor();
    const Eigen::Vector2d way = corner(k + 1).array().floor().matrix() - a;
    const int steps = static_cast<int>(way.cwiseAbs().maxCoeff());
    for (int t = 0; t <= steps; ++t) {
      const Eigen::Vector2d at = a + way * t / std::max(1, steps);
      const auto index = std::lround(at.y()) * side + std::lround(at.x());
      cells[static_cast<std::size_t>(index)] = OccupancyGrid::kOccupied;
    }
  }
  return std::make_shared<const OccupancyGrid>(Lattice(side, side, 0.05, {}), std::move(cells));
}

TEST(RangeTable, NeverSeesThroughSlantedWallsOneCellThin) {
  constexpr int kSide = 60;
  Rng rng(3);
  for (int n = 0; n < 40; ++n) {
    const MapPtr map = slantedRing(rng, kSide);
    const RangeTable table(*map, 10.0);  // farther than the ring is wide
    int inside = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
      const Cell cell = table.cell(i);
      if (std::hypot(cell.x - kSide / 2, cell.y - kSide / 2) > 0.1 * kSide) continue;
      ++inside;
      for (int d = 0; d < kDirections; ++d) ASSERT_LT(table.ranges(i)[d], kNoReturn) << n;
    }
    ASSERT_GT(inside, 50);
  }
}

TEST(RangeTable, TellsNoReturnFromTheFarthestRange) {
  const MapPtr map = toyWorld({"....................#"}, 0.1);
  const RangeTable table(*map, 1.5);
  const auto steps = [&](std::size_t i, int d) { return int{table.ranges(i)[d]}; };
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(steps(i, 90), kNoReturn);
    const double range = 0.1 * (20 - static_cast<double>(i));
    EXPECT_EQ(steps(i, 0), std::min<long>(kNoReturn, std::lround(range / 1.5 * kNoReturn))) << i;
  }
  for (std::size_t d = kDirections; d < kRangeStride; ++d) {
    EXPECT_EQ(table.ranges(0)[d], 0) << "padding";
  }
}

TEST(RangeTable, LooksThroughUnknownCellsAndNeedsNoneAroundTheMap) {
  const RangeTable known(*toyWorld({"...#", "...."}, 0.1), 3.0);
  const RangeTable framed(*toyWorld({"????????", "??...#??", "??....??", "????????"}, 0.1), 3.0);
  EXPECT_TRUE(haveSameBytes(known, framed));
  const RangeTable seen(*toyWorld({".??#"}, 0.1), 3.0);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(rangeIn(seen, 0, 0), 0.3, 0.01);
}

TEST(RangeTable, TurnsWithTheMapsOrigin) {
  const Pose2 origin{-3.0, 2.0, 2.1};
  const RangeTable turned(*smallRoom(origin), 5.0), straight(*smallRoom(), 5.0);
  ASSERT_TRUE(haveSameBytes(turned, straight));
  for (std::size_t i = 0; i < turned.size(); ++i) {
    EXPECT_TRUE(turned.centre(i).isApprox(origin * straight.centre(i)));
  }
  const auto errors = errorsOf(smallRoom(origin), turned, 2000);
  EXPECT_LE(errors[errors.size() / 2], 0.6);
}

TEST(RangeTable, TakesEverySoManiethCellWithTheSameRanges) {
  Rng rng(4);
  std::vector<std::int8_t> cells(40 * 30, OccupancyGrid::kUnknown);
  for (std::size_t i = 0; i < cells.size(); ++i) {  // known cells begin anywhere
    const bool is_known = i % 40 >= 7 && i % 40 < 38 && i / 40 >= 4;
    if (is_known) cells[i] = rng.below(8) == 0 ? OccupancyGrid::kOccupied : OccupancyGrid::kFree;
  }
  const OccupancyGrid map(Lattice(40, 30, 0.1, {}), cells);
  const RangeTable all(map, 2.0);
  for (const int spacing : {2, 3, 5}) {
    const RangeTable some(map, 2.0, spacing);
    EXPECT_EQ(some.spacing(), spacing);
    std::size_t taken = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Cell cell = all.cell(i);
      if (cell.x % spacing != 0 || cell.y % spacing != 0) continue;
      ASSERT_LT(taken, some.size());
      EXPECT_EQ(map.lattice().index(some.cell(taken)), map.lattice().index(cell));
      EXPECT_EQ(std::memcmp(some.ranges(taken++), all.ranges(i), kRangeStride), 0);
    }
    EXPECT_EQ(taken, some.size());
    EXPECT_GT(taken, 10U);
  }
}

TEST(RangeTable, FindsACellThatTheSpacingWouldMiss) {
  EXPECT_EQ(RangeTable(*toyWorld({"####", "#.##", "####"}, 0.1), 2.0, 2).size(), 1U);
}

TEST(RangeTable, IsTheSameForAnyNumberOfThreads) {
  const MapPtr map = maze();
  setThreads(4);
  const RangeTable four(*map, 10.0);
  setThreads(1);
  EXPECT_TRUE(haveSameBytes(four, RangeTable(*map, 10.0)));
}

TEST(RangeTable, StopsWhenItIsNoLongerWanted) {
  StopSource source;
  const StopToken stop = source.token();
  EXPECT_NO_THROW(RangeTable(*maze(), 10.0, 1, stop));
  source.stop();
  EXPECT_THROW(RangeTable(*maze(), 10.0, 1, stop), Stopped);
  EXPECT_THROW(DistanceField(*maze(), stop), Stopped);
}

TEST(RangeTable, ComplainsAboutWhatMakesNoTable) {
  const auto make = [](const Art& art, double max_range, int spacing) {
    return [=] { RangeTable(*toyWorld(art, 0.1), max_range, spacing); };
  };
  EXPECT_THAT(make({"##", "?#"}, 5.0, 1), ThrowsMessage<std::invalid_argument>(
                                              HasSubstr("no free cell, expected at least one")));
  EXPECT_THAT(make({"??", "??"}, 5.0, 3),
              ThrowsMessage<std::invalid_argument>(HasSubstr("no free cell")));
  EXPECT_THAT(make({"."}, 0.0, 1), ThrowsMessage<std::invalid_argument>(HasSubstr("max_range 0")));
  EXPECT_THAT(make({"."}, std::nan(""), 1), ThrowsMessage<std::invalid_argument>(
                                                AllOf(HasSubstr("max_range"), HasSubstr("nan"))));
  EXPECT_THAT(make({"."}, 1.0, 0), ThrowsMessage<std::invalid_argument>(HasSubstr("spacing 0")));
}

}  // namespace
}  // namespace adaptive_localization
