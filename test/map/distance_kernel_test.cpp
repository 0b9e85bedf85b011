// SPDX-License-Identifier: BSD-3-Clause
#include "map/distance_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace adaptive_localization {
namespace {

constexpr int kColumns = 150, kRows = 90, kReach = 320;  // more than one tile each way

/// Nearnesses up to the reach, with a border that is not near.
SparseGrid randomTable(std::mt19937& rng) {
  std::uniform_int_distribution<int> nearness(0, kReach);
  SparseGrid table(kColumns + 2, kRows + 2);
  for (int y = 1; y <= kRows; ++y) {
    for (int x = 1; x <= kColumns; ++x) {
      table.set(x, y, static_cast<std::uint16_t>(nearness(rng)));
    }
  }
  return table;
}

NearnessView viewOf(const SparseGrid& table) {
  return {table.values(), table.stride(), kColumns, kRows, kReach};
}

int cellAt(const SparseGrid& table, int x, int y) {
  return kReach - table.at(x + 1, y + 1);
}

TEST(DistanceKernel, IsExactAtCentresAndLinearBetweenThem) {
  std::mt19937 rng(1);
  const SparseGrid table = randomTable(rng);
  for (const auto& [x, y] : {std::pair{0, 0}, {62, 30}, {63, 31}, {64, 32}, {148, 88}}) {
    const int here = cellAt(table, x, y), right = cellAt(table, x + 1, y);
    const int above = cellAt(table, x, y + 1), beyond = cellAt(table, x + 1, y + 1);
    EXPECT_EQ(stepsBetween(viewOf(table), x, y), here);
    EXPECT_DOUBLE_EQ(stepsBetween(viewOf(table), x + 0.25, y), 0.75 * here + 0.25 * right);
    EXPECT_DOUBLE_EQ(stepsBetween(viewOf(table), x, y + 0.5), 0.5 * (here + above));
    EXPECT_DOUBLE_EQ(stepsBetween(viewOf(table), x + 0.5, y + 0.5),
                     0.25 * (here + right + above + beyond));
  }
}

TEST(DistanceKernel, IsTheNearestCellAtTheBorderAndTheReachBeyond) {
  std::mt19937 rng(2);
  const SparseGrid table = randomTable(rng);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(stepsBetween(viewOf(table), -0.4, 0.0), cellAt(table, 0, 0));
  EXPECT_EQ(stepsBetween(viewOf(table), kColumns - 0.6, kRows - 0.6),
            cellAt(table, kColumns - 1, kRows - 1));
  for (const auto& [x, y] : {std::pair{-0.5, 3.0},
                             {3.0, -7.0},
                             {kColumns - 0.5, 3.0},
                             {3.0, 1e300},
                             {nan, 3.0},
                             {3.0, nan}}) {
    EXPECT_EQ(stepsBetween(viewOf(table), x, y), kReach) << x << ", " << y;
  }
}

/// Some of the points are beyond the map, some are nowhere; the number is no multiple of four.
TEST(DistanceKernel, TheFastestSumsToTheSameBits) {
  std::mt19937 rng(3);
  const SparseGrid table = randomTable(rng);
  std::uniform_real_distribution<float> at(-12.0F, 12.0F);
  std::uniform_real_distribution<double> turn(-4.0, 4.0), column(-5.0, kColumns + 5.0),
      row(-5.0, kRows + 5.0);
  std::vector<float> x(361), y(361);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = at(rng);
    y[i] = at(rng);
  }
  x[17] = std::numeric_limits<float>::quiet_NaN();
  y[200] = std::numeric_limits<float>::infinity();
  for (int k = 0; k < 500; ++k) {
    const double theta = turn(rng);
    const PointFrame frame{column(rng), row(rng), 3.0 * std::cos(theta), 3.0 * std::sin(theta)};
    for (const std::ptrdiff_t stride : {1, 4}) {
      const PointColumns points{x.data(), y.data(), static_cast<std::ptrdiff_t>(x.size()), stride};
      const double sum = sumOfStepsPortable(viewOf(table), frame, points, 100.0);
      EXPECT_EQ(fastestSumOfSteps()(viewOf(table), frame, points, 100.0), sum);
      double one_by_one = 0.0;
      for (std::ptrdiff_t i = 0; i < points.count; i += stride) {
        const double px = points.x[i], py = points.y[i];
        one_by_one +=
            std::min(100.0, stepsBetween(viewOf(table), frame.x + frame.c * px - frame.s * py,
                                         frame.y + frame.s * px + frame.c * py));
      }
      EXPECT_EQ(sum, one_by_one);
      EXPECT_GT(sum, 0.0);
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
