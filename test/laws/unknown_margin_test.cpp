// SPDX-License-Identifier: BSD-3-Clause
// Unknown ground around a map changes nothing, and takes next to no memory.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "map/thin_walls.hpp"
#include "ser/range_table.hpp"

namespace adaptive_localization {
namespace {

constexpr int kLeft = 70, kBelow = 45, kRight = 33, kAbove = 120;  // cells of the margin

/// The same map, its cells numbered from elsewhere.
OccupancyGrid withMargin(const OccupancyGrid& map) {
  const Lattice& inner = map.lattice();
  const double resolution = inner.resolution();
  const Pose2 corner{-kLeft * resolution, -kBelow * resolution, 0.0};
  const Lattice lattice(kLeft + inner.width() + kRight, kBelow + inner.height() + kAbove,
                        resolution, inner.origin() * corner);
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const Cell cell = inner.cell(i);
    cells[lattice.index({cell.x + kLeft, cell.y + kBelow})] = map.at(cell);
  }
  return OccupancyGrid(lattice, cells);
}

class UnknownMargin : public testing::TestWithParam<int> {
 protected:
  /// Walls of one cell or several in a map whose margin is partly unknown itself.
  static OccupancyGrid drawn(int number) {
    Rng rng(static_cast<std::uint64_t>(number) + 1);
    const Lattice lattice(90, 70, 0.05, {});
    std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Cell cell = lattice.cell(i);
      if (cell.x >= 8 && cell.y >= 5 && cell.x < 80) cells[i] = OccupancyGrid::kFree;
    }
    for (int wall = 0; wall < 12; ++wall) {
      const Cell first{static_cast<int>(rng.below(60)), static_cast<int>(rng.below(50))};
      const bool is_thick = rng.uniform() < 0.5;
      const int length = 3 + static_cast<int>(rng.below(25)), depth = is_thick ? 7 : 1;
      for (int i = 0; i < length * depth; ++i) {
        cells[lattice.index({first.x + i % length, first.y + i / length})] =
            OccupancyGrid::kOccupied;
      }
    }
    return OccupancyGrid(lattice, cells);
  }

  void expectSameCells(const OccupancyGrid& of_map, const OccupancyGrid& of_wide) const {
    const OccupancyGrid expected = withMargin(of_map);
    EXPECT_EQ(of_wide.cells(), expected.cells());
  }

  const OccupancyGrid map_ = drawn(GetParam());
  const OccupancyGrid wide_ = withMargin(map_);
};

TEST_P(UnknownMargin, ThinAndHollowWallsAreTheSame) {
  expectSameCells(withThinWalls(map_, 0.3), withThinWalls(wide_, 0.3));
  expectSameCells(withHollowWalls(map_), withHollowWalls(wide_));
  EXPECT_NE(withHollowWalls(map_).cells(), map_.cells());
}

TEST_P(UnknownMargin, DistancesAreTheSame) {
  const DistanceField field(map_), wide(wide_);
  for (std::size_t i = 0; i < map_.lattice().size(); ++i) {
    const Cell cell = map_.lattice().cell(i);
    ASSERT_EQ(wide.stepsTo({cell.x + kLeft, cell.y + kBelow}), field.stepsTo(cell)) << i;
  }
  EXPECT_EQ(wide.quality().wallDepth(), field.quality().wallDepth());
}

TEST_P(UnknownMargin, RangesAreTheSame) {
  const RangeTable table(map_, 6.0), wide(wide_, 6.0);
  ASSERT_EQ(wide.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    ASSERT_EQ(wide.cell(i).x, table.cell(i).x + kLeft);
    ASSERT_EQ(wide.cell(i).y, table.cell(i).y + kBelow);
    ASSERT_EQ(std::memcmp(wide.ranges(i), table.ranges(i), kRangeStride), 0) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, UnknownMargin, testing::Range(0, 6));

TEST(UnknownGround, TakesNoMemory) {
  const Lattice lattice(40000, 20000, 0.05, {});
  const std::vector<std::int8_t> unknown(40000, OccupancyGrid::kUnknown);
  std::vector<std::int8_t> room = unknown;
  for (std::size_t x = 30000; x < 30100; ++x) room[x] = OccupancyGrid::kFree;
  const OccupancyGrid map = OccupancyGrid::fromRows(
      lattice, [&](int row) { return row >= 500 && row < 600 ? room.data() : unknown.data(); });
  EXPECT_EQ(map.countFree(), 10000U);
  EXPECT_EQ(map.knownCells().capacity(), 10000U);
  EXPECT_TRUE(map.isFree({30050, 550}));
  EXPECT_FALSE(map.isFree({39999, 19999}));
}

}  // namespace
}  // namespace adaptive_localization
