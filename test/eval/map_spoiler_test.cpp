// SPDX-License-Identifier: BSD-3-Clause
#include "eval/map_spoiler.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr int kWidth = 400, kHeight = 300;
constexpr int kWall = 100;  // row and column of a wall each
const Lattice kLattice(kWidth, kHeight, 0.05, {-3.0, 2.0, 0.0});

/// Free ground with a wall of one cell along x and one along y, and an unknown corner.
OccupancyGrid cross() {
  std::vector<std::int8_t> cells(kLattice.size(), OccupancyGrid::kFree);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = kLattice.cell(i);
    if (cell.x == kWall || cell.y == kWall) cells[i] = OccupancyGrid::kOccupied;
    if (cell.x > 380 && cell.y > 280) cells[i] = OccupancyGrid::kUnknown;
  }
  return {kLattice, cells};
}

struct Counts {
  int free{0}, occupied{0}, unknown{0};
};

Counts count(const OccupancyGrid& map) {
  Counts counts;
  for (std::size_t i = 0; i < map.lattice().size(); ++i) {
    const Cell cell = map.lattice().cell(i);
    ++(map.isFree(cell) ? counts.free : map.isOccupied(cell) ? counts.occupied : counts.unknown);
  }
  return counts;
}

/// The share of the cells that were of a kind and are so no longer, of those that were.
double shareGone(int before, int after) {
  return static_cast<double>(before - after) / before;
}

/// The rows that are wall in a column.
std::vector<int> wallRows(const OccupancyGrid& map, int column) {
  std::vector<int> rows;
  for (int y = 0; y < map.lattice().height(); ++y) {
    if (map.isOccupied({column, y})) rows.push_back(y);
  }
  return rows;
}

TEST(MapSpoiler, ThickGrowsWallsByTheAmountOnEverySide) {
  for (const int cells : {2, 4, 6}) {
    const OccupancyGrid map = spoil(cross(), "thick", 0.05 * cells, 1);
    const auto rows = wallRows(map, 300);
    ASSERT_EQ(rows.size(), 2U * static_cast<std::size_t>(cells) + 1U);
    EXPECT_EQ(rows.front(), kWall - cells) << "the middle stays where it was";
    EXPECT_TRUE(map.isOccupied({kWall - cells, 200}));
    EXPECT_FALSE(map.isOccupied({kWall + cells + 1, 200}));
  }
}

TEST(MapSpoiler, ThickGrowsAPointToADisc) {
  std::vector<std::int8_t> cells(kLattice.size(), OccupancyGrid::kFree);
  cells[kLattice.index({200, 150})] = OccupancyGrid::kOccupied;
  const Counts counts = count(spoil({kLattice, cells}, "thick", 1.0, 1));
  EXPECT_NEAR(counts.occupied, kPi * 20.0 * 20.0, 30.0);
}

TEST(MapSpoiler, CoarseKeepsWallsAndOrigin) {
  const OccupancyGrid map = spoil(cross(), "coarse", 0.15, 1);
  EXPECT_EQ(map.lattice(), Lattice(134, 100, 3 * 0.05, kLattice.origin())) << "400 / 3, rounded up";
  for (int x = 0; x < 134; ++x) EXPECT_TRUE(map.isOccupied({x, kWall / 3}));
  EXPECT_TRUE(map.isFree({0, 0}));
  EXPECT_FALSE(map.isFree({133, 99})) << "nothing was known there";
}

TEST(MapSpoiler, StretchScalesAboutTheMiddle) {
  const OccupancyGrid before = cross();
  const OccupancyGrid map = spoil(before, "stretch", 0.1, 1);
  EXPECT_EQ(map.lattice().width(), 440);
  EXPECT_EQ(map.lattice().height(), kHeight);
  const double middle = -3.0 + 0.5 * 0.05 * kWidth;
  const double wall = kLattice.centre({kWall, 0}).x();
  const Eigen::Vector2d moved{middle + 1.1 * (wall - middle), 5.0};
  EXPECT_TRUE(map.isOccupied(map.lattice().cellAt(moved)));
  EXPECT_FALSE(map.isOccupied(map.lattice().cellAt({wall, 5.0})));
  EXPECT_FALSE(map.isOccupied(map.lattice().cellAt({moved.x() - 0.1, 5.0})));
}

TEST(MapSpoiler, BendRaisesTheEndsAsAParabolaUpToAQuarterMetre) {
  const OccupancyGrid map = spoil(cross(), "bend", 0.01, 1);
  const auto riseAt = [&](double x) {  // from the middle, m
    const auto rows = wallRows(map, kWidth / 2 + static_cast<int>(std::lround(x / 0.05)));
    return 0.05 * (rows.front() - kWall);
  };
  EXPECT_NEAR(riseAt(0.0), 0.0, 1e-9);
  EXPECT_NEAR(riseAt(6.0), 0.5 * 0.01 * 36.0, 0.026);
  EXPECT_NEAR(riseAt(9.9), 0.25, 1e-9);
  EXPECT_NEAR(riseAt(-9.9), 0.25, 1e-9);
  EXPECT_EQ(map.lattice().height(), kHeight + 5) << "nothing is cut off";
}

TEST(MapSpoiler, ShiftMovesTheOrigin) {
  const OccupancyGrid map = spoil(cross(), "shift", -0.2, 1);
  EXPECT_EQ(map.lattice(), Lattice(kWidth, kHeight, 0.05, {-3.2, 1.8, 0.0}));
  EXPECT_EQ(map.cells(), cross().cells());
}

TEST(MapSpoiler, GapsFreeThatShareOfTheWallsInPieces) {
  const Counts before = count(cross());
  const OccupancyGrid map = spoil(cross(), "gaps", 0.3, 1);
  const Counts after = count(map);
  EXPECT_NEAR(shareGone(before.occupied, after.occupied), 0.3, 0.03);
  EXPECT_EQ(after.unknown, before.unknown);
  int ends = 0;
  for (int x = 1; x < kWidth; ++x) {
    ends += map.isOccupied({x, kWall}) != map.isOccupied({x - 1, kWall});
  }
  EXPECT_GT(ends, 2);
  EXPECT_LT(ends, 40) << "pieces, not single cells";
}

TEST(MapSpoiler, ClutterCoversThatShareOfTheFreeGroundWithBoxes) {
  const Counts before = count(cross());
  const OccupancyGrid map = spoil(cross(), "clutter", 0.05, 1);
  const Counts after = count(map);
  EXPECT_NEAR(shareGone(before.free, after.free), 0.05, 0.003);
  EXPECT_EQ(after.unknown, before.unknown);
  int faces = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 1; x < kWidth; ++x) faces += map.isOccupied({x, y}) && map.isFree({x - 1, y});
  }
  const double depth = static_cast<double>(after.occupied - before.occupied) / (faces - kHeight);
  EXPECT_NEAR(0.05 * depth, 0.55, 0.2) << "boxes of 0.3 to 0.8 m";
}

TEST(MapSpoiler, DottedAndSpeckleChangeSingleCells) {
  const Counts before = count(cross());
  const Counts dotted = count(spoil(cross(), "dotted", 0.5, 1));
  EXPECT_NEAR(shareGone(before.occupied, dotted.occupied), 0.5, 0.06);
  EXPECT_EQ(dotted.free, before.free);
  const Counts speckled = count(spoil(cross(), "speckle", 0.1, 1));
  EXPECT_NEAR(shareGone(before.free, speckled.free), 0.1, 0.004);
  EXPECT_NEAR(speckled.occupied - before.occupied, speckled.unknown - before.unknown, 400);
}

TEST(MapSpoiler, ASeedGivesTheSameMapAndAnotherAnother) {
  for (const auto& damage : mapDamages()) {
    const auto with = [&](std::uint64_t seed) {
      return spoil(cross(), damage.kind.name, damage.kind.amount, seed).cells();
    };
    EXPECT_EQ(with(7), with(7)) << damage.kind.name;
  }
  for (const char* kind : {"gaps", "clutter", "dotted", "speckle"}) {
    EXPECT_NE(spoil(cross(), kind, 0.1, 7).cells(), spoil(cross(), kind, 0.1, 8).cells()) << kind;
  }
}

TEST(MapSpoiler, StaysWithinReasonOnMapsWithoutWallsOrFreeGround) {
  for (const std::int8_t value : {OccupancyGrid::kFree, OccupancyGrid::kOccupied}) {
    const OccupancyGrid map(Lattice(3, 2, 0.1, {}), std::vector<std::int8_t>(6, value));
    for (const auto& damage : mapDamages()) {
      EXPECT_GT(spoil(map, damage.kind.name, damage.kind.range.high, 1).lattice().size(), 0U);
      EXPECT_GT(spoil(map, damage.kind.name, damage.kind.range.low, 1).lattice().size(), 0U);
    }
  }
}

TEST(MapSpoiler, RefusesUnknownKindsAndAmounts) {
  EXPECT_THAT([] { spoil(cross(), "slip", 1.0, 1); },
              ThrowsMessage<std::invalid_argument>(
                  AllOf(HasSubstr("got 'slip', expected one of thick, coarse, "))));
  EXPECT_THAT([] { spoil(cross(), "gaps", 0.95, 1); },
              ThrowsMessage<std::invalid_argument>("damage 'gaps': got 0.95, expected 0 to 0.9"));
  EXPECT_THAT([] { spoil(cross(), "thick", std::nan(""), 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("expected 0.001 to 10 m")));
}

}  // namespace
}  // namespace adaptive_localization
