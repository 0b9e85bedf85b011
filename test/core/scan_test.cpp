// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/core/scan.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const float kNan = std::numeric_limits<float>::quiet_NaN();
const float kInf = std::numeric_limits<float>::infinity();

LaserScan message(std::vector<float> ranges, double angle_min = 0.0, double increment = 0.1) {
  LaserScan scan;
  scan.angle_min = angle_min;
  scan.angle_increment = increment;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  scan.ranges = std::move(ranges);
  return scan;
}

ScanOptions beams(int count) {
  ScanOptions options;
  options.laser_max_beams = count;
  return options;
}

std::string complaint(const LaserScan& scan) {
  try {
    toScan(scan, LaserMount{}, ScanOptions{});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(ToScan, KeepsHitsNoReturnsAndInvalidBeamsApart) {
  const Scan scan = toScan(message({1.0F, kInf, kNan, 10.0F, 0.05F, 0.0F, -1.0F, -kInf, 0.1F}),
                           LaserMount{}, beams(100));
  ASSERT_EQ(scan.hits(), 2);
  EXPECT_FLOAT_EQ(scan.range[0], 1.0F);
  EXPECT_FLOAT_EQ(scan.range[1], 0.1F);
  ASSERT_EQ(scan.no_return_bearing.size(), 2);
  EXPECT_NEAR(scan.no_return_bearing[0], 0.1, 1e-6);
  EXPECT_NEAR(scan.no_return_bearing[1], 0.3, 1e-6);
  EXPECT_EQ(scan.invalid, 5);
  EXPECT_EQ(scan.max_range, 10.0);
}

TEST(ToScan, PutsEndPointsIntoTheBaseFrame) {
  const Pose2 T_base_laser{0.3, -0.1, kPi / 2};
  const Scan scan = toScan(message({2.0F}), LaserMount::level(T_base_laser), beams(10));
  EXPECT_NEAR(scan.x[0], 0.3, 1e-6);
  EXPECT_NEAR(scan.y[0], 1.9, 1e-6);
  EXPECT_NEAR(scan.bearing[0], kPi / 2, 1e-6);
  EXPECT_TRUE(scan.position.isApprox(Eigen::Vector2d(0.3, -0.1)));
}

TEST(ToScan, ObeysLimitsNarrowerThanTheMessages) {
  ScanOptions options;
  options.laser_min_range = 0.5;
  options.laser_max_range = 3.0;
  const Scan scan = toScan(message({0.3F, 0.5F, 2.0F, 3.0F, 8.0F}), LaserMount{}, options);
  EXPECT_EQ(scan.hits(), 2);
  EXPECT_EQ(scan.invalid, 1);
  EXPECT_EQ(scan.no_return_bearing.size(), 2);
  EXPECT_EQ(scan.max_range, 3.0);

  options.laser_min_range = -1.0;
  options.laser_max_range = 99.0;  // wider: the message's stands
  EXPECT_EQ(toScan(message({1.0F}), LaserMount{}, options).max_range, 10.0);
}

/// Bearings of the beams used of a scan of n, each beam's bearing being its number.
std::vector<int> used(int n, int max_beams) {
  LaserScan scan = message(std::vector<float>(static_cast<std::size_t>(n), 1.0F), 0.0, 1e-3);
  const Scan thinned = toScan(scan, LaserMount{}, beams(max_beams));
  std::vector<int> numbers;
  for (Eigen::Index i = 0; i < thinned.bearing.size(); ++i) {
    numbers.push_back(static_cast<int>(std::lround(thinned.bearing[i] * 1e3F)));
  }
  return numbers;
}

TEST(ToScan, TakesBeamsOutsideTheLasersViewForInvalid) {
  LaserMount mount;
  mount.view = {-0.05, 0.25};
  const Scan scan = toScan(message({1.0F, 2.0F, 3.0F, kInf}, -0.1), mount, beams(100));
  ASSERT_EQ(scan.hits(), 2);
  EXPECT_FLOAT_EQ(scan.range[0], 2.0F);
  EXPECT_FLOAT_EQ(scan.range[1], 3.0F);
  EXPECT_EQ(scan.no_return_bearing.size(), 1);
  EXPECT_EQ(scan.invalid, 1);
}

TEST(ToScan, ThinsEvenlyFromTheFirstBeamToTheLast) {
  for (const auto& [n, max_beams] : {std::pair{181, 60}, {180, 60}, {100, 99}, {1000, 2}, {7, 3}}) {
    const std::vector<int> numbers = used(n, max_beams);
    ASSERT_EQ(static_cast<int>(numbers.size()), max_beams);
    EXPECT_EQ(numbers.front(), 0);
    EXPECT_EQ(numbers.back(), n - 1);
    const double step = (n - 1.0) / (max_beams - 1.0);
    for (int k = 0; k < max_beams; ++k) {
      EXPECT_NEAR(numbers[static_cast<std::size_t>(k)], k * step, 0.501) << n << " " << max_beams;
    }
  }
}

TEST(ToScan, UsesAllBeamsIfThereAreFew) {
  EXPECT_THAT(used(5, 60), testing::ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(used(5, 5), testing::ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(used(1, 60), testing::ElementsAre(0));
}

TEST(ToScan, TakesScansOfChangingShape) {
  for (const int n : {181, 180, 181, 180}) {
    const std::vector<float> ranges(static_cast<std::size_t>(n), 2.0F);
    const Scan scan = toScan(message(ranges, -kPi / 2, kPi / 180), LaserMount{}, beams(400));
    ASSERT_EQ(scan.hits(), n);
    EXPECT_NEAR(scan.bearing[n - 1], -kPi / 2 + (n - 1) * kPi / 180, 1e-5);
  }
}

TEST(ToScan, SeesTheSamePointsWithTheIncrementReversed) {
  const std::vector<float> ranges{1.0F, 2.0F, kInf, 3.0F};
  const std::vector<float> reversed(ranges.rbegin(), ranges.rend());
  const Scan there = toScan(message(ranges, 0.2, 0.1), LaserMount{}, beams(10));
  const Scan back = toScan(message(reversed, 0.5, -0.1), LaserMount{}, beams(10));
  ASSERT_EQ(there.hits(), back.hits());
  for (Eigen::Index i = 0; i < there.x.size(); ++i) {
    EXPECT_NEAR(there.x[i], back.x[there.x.size() - 1 - i], 1e-6);
    EXPECT_NEAR(there.y[i], back.y[there.y.size() - 1 - i], 1e-6);
  }
}

TEST(ToScan, MirrorsALaserMountedUpsideDown) {
  const Pose2 T_base_laser{0.2, 0.1, 0.5};
  const Scan scan = toScan(message({2.0F}, 0.3), LaserMount::upsideDown(T_base_laser), beams(10));
  const Eigen::Vector2d expected =
      T_base_laser * Eigen::Vector2d(2.0 * std::cos(-0.3), 2.0 * std::sin(-0.3));
  EXPECT_NEAR(scan.x[0], expected.x(), 1e-6);
  EXPECT_NEAR(scan.y[0], expected.y(), 1e-6);
  EXPECT_NEAR(scan.bearing[0], 0.5 - 0.3, 1e-6);
}

TEST(ToScan, ShortensWhatATiltedLaserSees) {
  LaserMount mount;  // nose down by 60 degrees: ahead shrinks to half
  mount.axes << 0.5, 0.0, 0.0, 1.0;
  const Scan scan = toScan(message({4.0F, 4.0F}, 0.0, kPi / 2), mount, beams(10));
  EXPECT_NEAR(scan.x[0], 2.0, 1e-6);
  EXPECT_NEAR(scan.range[0], 2.0, 1e-6);
  EXPECT_NEAR(scan.y[1], 4.0, 1e-6);
  EXPECT_NEAR(scan.range[1], 4.0, 1e-6);
}

TEST(ToScan, NamesWhatMakesNoScan) {
  EXPECT_THAT(complaint(message({})), HasSubstr("beams"));
  EXPECT_THAT(complaint(message({1.0F}, std::nan(""))), HasSubstr("angle_min"));
  EXPECT_THAT(complaint(message({1.0F, 1.0F}, 0.0, 0.0)), HasSubstr("angle_increment"));
  EXPECT_THAT(complaint(message({1.0F, 1.0F}, 0.0, kInf)), HasSubstr("angle_increment"));
  LaserScan scan = message({1.0F});
  scan.range_min = -0.1;
  EXPECT_THAT(complaint(scan), AllOf(HasSubstr("range_min"), HasSubstr("-0.1")));
  scan = message({1.0F});
  scan.range_max = 0.1;
  EXPECT_THAT(complaint(scan), HasSubstr("range_max"));
  scan.range_max = std::nan("");
  EXPECT_THAT(complaint(scan), HasSubstr("range_max"));
}

TEST(ToScan, TakesOneBeamWithoutAnIncrement) {
  EXPECT_EQ(toScan(message({1.0F}, 0.0, 0.0), LaserMount{}, beams(60)).hits(), 1);
}

TEST(ToScan, GivesFiniteNumbersForAnUnlimitedLaser) {
  LaserScan unlimited = message({1.0F, kInf});
  unlimited.range_max = kInf;
  const Scan scan = toScan(unlimited, LaserMount{}, beams(60));
  EXPECT_EQ(scan.hits(), 1);
  EXPECT_EQ(scan.no_return_bearing.size(), 1);
  EXPECT_TRUE(std::isfinite(scan.max_range));
}

TEST(ToScan, EitherComplainsOrGivesFiniteNumbersForAnyMessage) {
  Rng rng(1);
  const double odd[] = {0.0, 1.0, -1.0, 0.1, 10.0, 1e30, -1e308, 1e308, kNan, kInf, -kInf};
  const auto pick = [&] { return odd[rng.below(std::size(odd))]; };
  int taken = 0;
  for (int i = 0; i < 20000; ++i) {
    LaserScan scan;
    scan.angle_min = pick();
    scan.angle_increment = pick();
    scan.range_min = pick();
    scan.range_max = pick();
    for (std::size_t n = rng.below(6); n > 0; --n) {
      scan.ranges.push_back(static_cast<float>(pick()));
    }
    ScanOptions options = beams(2 + static_cast<int>(rng.below(4)));
    options.laser_min_range = rng.uniform(-1.0, 2.0);
    options.laser_max_range = rng.uniform(-1.0, 2.0);
    try {
      const Scan result = toScan(scan, LaserMount::level({0.1, 0.2, 0.3}), options);
      ++taken;
      const auto all = static_cast<std::size_t>(result.hits()) +
                       static_cast<std::size_t>(result.no_return_bearing.size()) +
                       static_cast<std::size_t>(result.invalid);
      ASSERT_EQ(all,
                std::min(scan.ranges.size(), static_cast<std::size_t>(options.laser_max_beams)));
      ASSERT_TRUE(result.x.allFinite() && result.y.allFinite() && result.range.allFinite());
      ASSERT_TRUE(result.bearing.allFinite() && result.no_return_bearing.allFinite());
      ASSERT_TRUE((result.range < static_cast<float>(result.max_range) * 1.000001F).all());
    } catch (const std::invalid_argument&) {
    }
  }
  EXPECT_GT(taken, 500);
}

}  // namespace
}  // namespace adaptive_localization
