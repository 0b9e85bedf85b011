// SPDX-License-Identifier: BSD-3-Clause
// What must hold of energies and similar energy regions, whatever the map and scan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "../ser/ser_toys.hpp"
#include "support/random_grid.hpp"

namespace adaptive_localization {
namespace {

/// A scan of the lattice as a laser would give it.
Scan asScan(const DirectionalScan& beams, const ScanGeometry& geometry) {
  LaserScan message;
  message.angle_min = geometry.first * kDirectionStep + geometry.offset;
  message.angle_increment = kDirectionStep;
  message.range_max = 2.0 * geometry.max_range;
  for (int k = 0; k < geometry.count; ++k) {
    const int range = beams.range[static_cast<std::size_t>(k)];
    message.ranges.push_back(
        range < 0 ? std::nanf("")
        : range == kNoReturn
            ? std::numeric_limits<float>::infinity()
            : static_cast<float>(std::max(1e-3, range * geometry.max_range / kNoReturn)));
  }
  return toScan(message);
}

/// Sum of the ranges of 30 beams, 6 degrees apart.
int sumOf(const std::uint8_t* ranges, int direction) {
  int sum = 0;
  for (int i = 0; i < 30; ++i) sum += ranges[(direction + 3 * i) % kDirections];
  return sum;
}

TEST(EnergyLaw, DifferenceOfEnergiesIsNeverMoreThanThatOfRanges) {
  const MapPtr map = maze();
  const RangeTable table(*map, 10.0);
  Rng rng(1);
  for (int n = 0; n < 100000; ++n) {
    const std::uint8_t* a = table.ranges(rng.below(table.size()));
    const std::uint8_t* b = table.ranges(rng.below(table.size()));
    const int at_a = static_cast<int>(rng.below(kDirections));
    const int at_b = static_cast<int>(rng.below(kDirections));
    int distance = 0;
    for (int i = 0; i < 30; ++i) {
      distance += std::abs(a[(at_a + 3 * i) % kDirections] - b[(at_b + 3 * i) % kDirections]);
    }
    ASSERT_LE(std::abs(sumOf(a, at_a) - sumOf(b, at_b)), distance);
  }
}

TEST(EnergyLaw, RegionIsWhatAFilterOfAllPosesGives) {
  const MapPtr map = smallRoom();
  const auto grid = gridOf(map);
  Rng rng(2);
  for (int n = 0; n < 500; ++n) {
    const ScanEnergy energy{rng.uniform(-0.2, 1.2), n % 10 == 0 ? 0.0 : rng.uniform(0.0, 0.5)};
    const auto region = grid->similarTo(energy);
    ASSERT_LE(region.begin, region.end);
    ASSERT_LE(region.end, grid->size());
    for (std::size_t i = 0; i < grid->size(); ++i) {
      const double off = std::abs(grid->energy(i) - energy.value);
      if (std::abs(off - energy.delta) < 1e-12) continue;  // on the border: rounding decides
      ASSERT_EQ(region.begin <= i && i < region.end, off < energy.delta)
          << energy.value << " " << i;
    }
  }
}

/// Which row of the table a pose of a grid is, and which of its directions is beam 0's.
std::pair<std::size_t, int> rowOf(const EnergyGrid& grid, const Pose2& pose) {
  const RangeTable& table = grid.ranges();
  const Cell at = table.lattice().cellAt({pose.x, pose.y});
  std::size_t row = 0;
  while (table.cell(row).x != at.x || table.cell(row).y != at.y) ++row;
  const double turned =
      wrapAngle(pose.theta - table.lattice().origin().theta - grid.geometry().headingOf(0));
  const int direction = static_cast<int>(std::lround(turned / kDirectionStep));
  return {row, (direction + kDirections) % kDirections};
}

TEST(EnergyLaw, RegionOfAPerfectScanHoldsItsPose) {
  Rng rng(3);
  for (const double occupied : {0.0, 0.01, 0.1, 0.4}) {
    const MapPtr map = randomGrid(rng, Lattice(30, 20, 0.2, {1.0, 2.0, 3.0}), occupied);
    for (const int count : {1, 45, 91, 136, 180}) {
      ScanGeometry geometry = halfCircle(4.0);
      geometry.count = count;
      const auto grid = gridOf(map, geometry);
      for (std::size_t i = rng.below(50); i < grid->size(); i += 50) {
        const auto [row, direction] = rowOf(*grid, grid->pose(i));
        const Scan scan = asScan(scanOf(grid->ranges(), row, direction, count), geometry);
        const auto energy = grid->energyOf(scan);
        ASSERT_TRUE(energy);
        ASSERT_NEAR(energy->value, grid->energy(i), 1e-9);
        ASSERT_GE(energy->value, 0.0);
        ASSERT_LE(energy->value, 1.0);
        const auto region = grid->similarTo(*energy);
        ASSERT_TRUE(region.begin <= i && i < region.end);
      }
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
