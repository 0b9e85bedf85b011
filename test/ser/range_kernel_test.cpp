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

constexpr std::array<int, RangeTarget::kParts> kWhole{0, 32, 64, 96, 128, 160};

RangeTarget targetOf(const Row& low, const Row& high) {
  return {low.data(), high.data(), kWhole, RangeTarget::kParts};
}

/// Intervals between two random rows; as a target all of them, or some parts in any order.
struct Rows {
  explicit Rows(Rng& rng) : low(randomRow(rng)), high(randomRow(rng)) {
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (low[i] > high[i]) std::swap(low[i], high[i]);
    }
  }

  RangeTarget target() const { return targetOf(low, high); }

  RangeTarget someParts(Rng& rng) {
    for (std::size_t i = parts.size(); i-- > 1;) std::swap(parts[i], parts[rng.below(i + 1)]);
    return {low.data(), high.data(), parts, 2 * static_cast<int>(rng.below(4))};
  }

  Row low, high;
  std::array<int, RangeTarget::kParts> parts = kWhole;
};

TEST(RangeKernel, IsTheSameWithAndWithoutVectorInstructions) {
  const RangeKernel fastest = fastestSumOfDistances();
  Rng rng(1);
  for (int n = 0; n < 20000; ++n) {
    const Rows a(rng);
    Rows b(rng);
    const RangeTarget target = b.someParts(rng);
    const int truncation = 1 + static_cast<int>(rng.below(255));
    const int most = static_cast<int>(rng.below(20000));
    ASSERT_EQ(fastest(a.low.data(), a.high.data(), target, truncation, most),
              sumOfDistancesPortable(a.low.data(), a.high.data(), target, truncation, most));
  }
}

TEST(RangeKernel, CutsOffOnlySumsThatAreGreater) {
  const RangeKernel sum = fastestSumOfDistances();
  Rng rng(2);
  for (int n = 0; n < 20000; ++n) {
    const Rows a(rng), b(rng);
    const int whole = sum(a.low.data(), a.high.data(), b.target(), 255, kAll);
    const int most = static_cast<int>(rng.below(20000));
    const int cut = sum(a.low.data(), a.high.data(), b.target(), 255, most);
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
  EXPECT_EQ(sum(a.data(), a.data(), targetOf(b, b), 255, kAll), 20 * bytes);
  EXPECT_EQ(sum(b.data(), b.data(), targetOf(a, a), 255, kAll), 20 * bytes);
  EXPECT_EQ(sum(b.data(), b.data(), targetOf(a, a), 7, kAll), 7 * bytes);
  EXPECT_EQ(sum(zero.data(), zero.data(), targetOf(most, most), 255, kAll), 255 * bytes);
  EXPECT_EQ(sum(a.data(), b.data(), targetOf(b, b), 255, kAll), 0);
  EXPECT_EQ(sum(a.data(), a.data(), targetOf(zero, most), 255, kAll), 0);
  const RangeTarget two{b.data(), b.data(), {160, 64}, 2};
  EXPECT_EQ(sum(a.data(), a.data(), two, 255, kAll), 20 * 2 * RangeTarget::kPart);
}

TEST(ScanTargets, HoldWhatEachDirectionShouldSee) {
  Rng rng(2);
  const DirectionalScan scan = randomScan(rng, 91);
  const ScanTargets targets(scan, 1);
  for (int first = 0; first < kDirections; ++first) {
    for (int beam = 0; beam < kDirections; ++beam) {
      const int range = scan.range[static_cast<std::size_t>(beam)];
      const int d = (first + beam) % kDirections;
      ASSERT_EQ(targets.of(first).low[d], range < 0 ? 0 : range);
      ASSERT_EQ(targets.of(first).high[d], range < 0 ? kNoReturn : range);
    }
  }
}

TEST(ScanTargets, NameThePartsThatTellAnything) {
  Rng rng(4);
  const RangeKernel sum = fastestSumOfDistances();
  for (const int beams : {0, 1, 20, 91, 135, 180}) {
    const DirectionalScan scan = randomScan(rng, beams);
    for (const int headings : {1, 3}) {
      const ScanTargets targets(scan, headings);
      for (int group = 0; group < targets.size(); ++group) {
        const RangeTarget& target = targets.of(group);
        ASSERT_EQ(target.count % 2, 0);
        ASSERT_LE(target.count, 2 * ((beams + headings) / (2 * RangeTarget::kPart) + 2));
        const RangeTarget whole{target.low, target.high, kWhole, RangeTarget::kParts};
        const Row row = randomRow(rng);
        ASSERT_EQ(sum(row.data(), row.data(), target, 255, kAll),
                  sum(row.data(), row.data(), whole, 255, kAll));
      }
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
      ASSERT_LE(grouped.of(heading / 3).low[d], one.of(heading).low[d]);
      ASSERT_GE(grouped.of(heading / 3).high[d], one.of(heading).high[d]);
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
