// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/ser/range_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "../../src/ser/scan_targets.hpp"
#include "ser_toys.hpp"

namespace adaptive_localization {
namespace {

constexpr int kAll = 255 * static_cast<int>(kRangeStride);

using Row = std::array<std::uint8_t, kRangeStride>;

Row randomRow(Rng& rng) {
  Row row;
  for (auto& value : row) value = static_cast<std::uint8_t>(rng.below(256));
  return row;
}

/// Intervals between two random rows.
struct Rows {
  explicit Rows(Rng& rng) : low(randomRow(rng)), high(randomRow(rng)) {
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (low[i] > high[i]) std::swap(low[i], high[i]);
    }
  }
  Row low, high;
};

TEST(RangeKernel, IsTheSameWithAndWithoutVectorInstructions) {
  const RangeKernel fastest = fastestSumOfDistances();
  Rng rng(1);
  for (int n = 0; n < 20000; ++n) {
    const Rows a(rng), b(rng);
    const int truncation = 1 + static_cast<int>(rng.below(255));
    const int most = static_cast<int>(rng.below(20000));
    ASSERT_EQ(fastest(a.low.data(), a.high.data(), b.low.data(), b.high.data(), truncation, most),
              sumOfDistancesPortable(a.low.data(), a.high.data(), b.low.data(), b.high.data(),
                                     truncation, most));
  }
}

TEST(RangeKernel, CutsOffOnlySumsThatAreGreater) {
  const RangeKernel sum = fastestSumOfDistances();
  Rng rng(2);
  for (int n = 0; n < 20000; ++n) {
    const Rows a(rng), b(rng);
    const int whole = sum(a.low.data(), a.high.data(), b.low.data(), b.high.data(), 255, kAll);
    const int most = static_cast<int>(rng.below(20000));
    const int cut = sum(a.low.data(), a.high.data(), b.low.data(), b.high.data(), 255, most);
    if (whole <= most) {
      ASSERT_EQ(cut, whole);
    } else {
      ASSERT_GT(cut, most);
    }
  }
}

TEST(RangeKernel, SumsTruncatedDistancesOfIntervals) {
  Row zero{}, most{}, a{}, b{};
  most.fill(255);
  a.fill(10);
  b.fill(30);
  const auto sum = fastestSumOfDistances();
  const int bytes = static_cast<int>(kRangeStride);
  EXPECT_EQ(sum(a.data(), a.data(), b.data(), b.data(), 255, kAll), 20 * bytes);
  EXPECT_EQ(sum(b.data(), b.data(), a.data(), a.data(), 255, kAll), 20 * bytes);
  EXPECT_EQ(sum(b.data(), b.data(), a.data(), a.data(), 7, kAll), 7 * bytes);
  EXPECT_EQ(sum(zero.data(), zero.data(), most.data(), most.data(), 255, kAll), 255 * bytes);
  EXPECT_EQ(sum(a.data(), b.data(), b.data(), b.data(), 255, kAll), 0);
  EXPECT_EQ(sum(a.data(), a.data(), zero.data(), most.data(), 255, kAll), 0);
}

TEST(ScanTargets, HoldWhatEachDirectionShouldSee) {
  Rng rng(2);
  const DirectionalScan scan = randomScan(rng, 91);
  const ScanTargets targets(scan, 1);
  for (int first = 0; first < kDirections; ++first) {
    for (int beam = 0; beam < kDirections; ++beam) {
      const int range = scan.range[static_cast<std::size_t>(beam)];
      const int d = (first + beam) % kDirections;
      ASSERT_EQ(targets.low(first)[d], range < 0 ? 0 : range);
      ASSERT_EQ(targets.high(first)[d], range < 0 ? kNoReturn : range);
    }
  }
}

TEST(ScanTargets, OfAGroupHoldAllOfItsHeadings) {
  Rng rng(3);
  const DirectionalScan scan = randomScan(rng, 180);
  const ScanTargets one(scan, 1), grouped(scan, 3);
  ASSERT_EQ(grouped.size(), 60);
  for (int heading = 0; heading < kDirections; ++heading) {
    for (int d = 0; d < kDirections; ++d) {
      ASSERT_LE(grouped.low(heading / 3)[d], one.low(heading)[d]);
      ASSERT_GE(grouped.high(heading / 3)[d], one.high(heading)[d]);
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
