// SPDX-License-Identifier: BSD-3-Clause
#include "ser/scan_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();
const float kInf = std::numeric_limits<float>::infinity();
constexpr double kDegree = kPi / 180.0;

/// Beam i reads i + 1 m unless told otherwise.
LaserScan message(int beams, double first_degrees, double step_degrees) {
  LaserScan scan;
  scan.angle_min = first_degrees * kDegree;
  scan.angle_increment = step_degrees * kDegree;
  scan.range_max = 1000.0;
  for (int i = 0; i < beams; ++i) scan.ranges.push_back(static_cast<float>(i + 1));
  return scan;
}

Scan scanOf(const LaserScan& scan, const LaserMount& mount = {}) {
  ScanOptions options;
  options.laser_max_beams = 1000;
  return toScan(scan, mount, options);
}

TEST(ScanGeometry, HasABeamInEachWholeDirectionOfTheView) {
  struct Case {
    int beams;
    double first, step;
    int expected_count;
  };
  for (const Case& c : {Case{181, -90, 1, 91},
                        {361, -90, 0.5, 91},
                        {91, -90, 2, 91},
                        {180, -90, 1, 90},
                        {60, -90, 3, 89},
                        {360, -180, 1, 180},
                        {361, -180, 1, 180},
                        {1, 0, 1, 1},
                        {2, -1, 2, 2},
                        {181, 90, -1, 91}}) {
    const ScanGeometry geometry = geometryOf(scanOf(message(c.beams, c.first, c.step)), 10.0);
    EXPECT_EQ(geometry.count, c.expected_count) << c.beams;
    const double start = geometry.first * kDirectionStep + geometry.offset;
    const double rightmost = std::min(c.first, c.first + c.step * (c.beams - 1)) * kDegree;
    EXPECT_NEAR(std::abs(wrapAngle(start - rightmost)), 0.0, 1e-3) << c.beams;
    EXPECT_GE(geometry.offset, 0.0);
    EXPECT_LT(geometry.offset, kDirectionStep);
  }
}

TEST(ScanGeometry, TakesTheShorterOfTwoLimits) {
  const Scan scan = scanOf(message(10, 0, 1));
  EXPECT_EQ(geometryOf(scan, 10.0).max_range, 10.0);
  EXPECT_EQ(geometryOf(scan, 2000.0).max_range, 1000.0);
}

TEST(ScanGeometry, KnowsTheHeadingThatPutsBeam0IntoADirection) {
  const LaserMount mount = LaserMount::level({0.1, 0.0, 0.3});
  const ScanGeometry geometry = geometryOf(scanOf(message(181, -90, 1), mount), 10.0);
  for (const int direction : {0, 1, 90, 179}) {
    const double beam_0 = geometry.headingOf(direction) + 0.3 - kPi / 2;  // rightmost, in the map
    EXPECT_NEAR(std::abs(wrapAngle(beam_0 - direction * kDirectionStep)), 0.0, 1e-3);
  }
  EXPECT_EQ(geometry.position, Eigen::Vector2d(0.1, 0.0));
}

TEST(ScanGeometry, IsTheSameForTheSameLaser) {
  const LaserScan still = message(181, -90, 1);
  LaserScan jitters = still;
  jitters.angle_min += 1e-7;  // as drivers' last digits do
  EXPECT_TRUE(geometryOf(scanOf(still), 10.0) == geometryOf(scanOf(jitters), 10.0));
  const LaserMount elsewhere = LaserMount::level({0.2, 0.0, 0.0});
  EXPECT_FALSE(geometryOf(scanOf(still), 10.0) == geometryOf(scanOf(still, elsewhere), 10.0));
  EXPECT_FALSE(geometryOf(scanOf(still), 10.0) == geometryOf(scanOf(still), 9.0));
}

TEST(Directions, AreFilledFromTheNearestBeam) {
  const Scan scan = scanOf(message(181, -90, 1));
  const DirectionalScan beams = toDirections(scan, geometryOf(scan, 100.0));
  EXPECT_EQ(beams.valid, 91);
  for (int k = 0; k < 91; ++k) {  // every second beam
    const double metres = std::min(100.0, 2.0 * k + 1.0);
    EXPECT_EQ(beams.range[static_cast<std::size_t>(k)], std::lround(metres / 100.0 * kNoReturn));
  }
  for (std::size_t k = 91; k < kDirections; ++k) EXPECT_EQ(beams.range[k], -1);
}

TEST(Directions, MirrorWithTheLaser) {
  LaserScan scan = message(181, -90, 1);
  const Scan level = scanOf(scan, LaserMount::level({}));
  const Scan mirrored = scanOf(scan, LaserMount::upsideDown({}));
  const ScanGeometry geometry = geometryOf(level, 100.0);
  EXPECT_TRUE(geometry == geometryOf(mirrored, 100.0));
  const DirectionalScan a = toDirections(level, geometry), b = toDirections(mirrored, geometry);
  for (std::size_t k = 0; k < 91; ++k) EXPECT_EQ(a.range[k], b.range[90 - k]);
}

TEST(Directions, TellNoReturnsFromInvalidBeams) {
  LaserScan scan = message(5, 0, 2);
  scan.ranges = {1.0F, kNan, kInf, 0.0F, 50.0F};
  const DirectionalScan beams = toDirections(scanOf(scan), geometryOf(scanOf(scan), 10.0));
  EXPECT_EQ(beams.range[0], std::lround(25.5));
  EXPECT_EQ(beams.range[1], -1);
  EXPECT_EQ(beams.range[2], kNoReturn);
  EXPECT_EQ(beams.range[3], -1);
  EXPECT_EQ(beams.range[4], kNoReturn) << "beyond the limit";
  EXPECT_EQ(beams.valid, 3);
}

TEST(Directions, WithoutABeamNearAreInvalid) {
  const Scan scan = scanOf(message(10, 0, 10));
  const DirectionalScan beams = toDirections(scan, geometryOf(scan, 10.0));
  for (std::size_t k = 0; k < kDirections; ++k) {
    EXPECT_EQ(beams.range[k] >= 0, k % 5 == 0 && k <= 45) << k;
  }
}

TEST(Directions, GoAllRound) {
  const Scan scan = scanOf(message(360, -180, 1));
  EXPECT_EQ(toDirections(scan, geometryOf(scan, 10.0)).valid, kDirections);
}

TEST(ScanGeometry, HasOneBeamInEachDirectionOrThoseOfACoarserLaser) {
  struct Case {
    int beams;
    double first, step;
    int expected_beams, expected_last_direction;
  };
  for (const Case& c : {Case{181, -90, 1, 91, 90},
                        {60, -90, 180.0 / 59, 60, 90},
                        {7, -90, 30, 7, 90},
                        {2, -90, 180, 2, 90},
                        {1, 0, 0, 1, 0},
                        {360, -180, 1, 180, 179},
                        {36, -180, 10, 36, 175},
                        {37, -180, 10, 36, 175},  // the last beam is the first one again
                        {10, 135, -30, 10, 135}}) {
    const ScanGeometry geometry = geometryOf(scanOf(message(c.beams, c.first, c.step)), 10.0);
    EXPECT_EQ(geometry.beams(), c.expected_beams) << c.beams;
    EXPECT_EQ(geometry.directionOf(geometry.beams() - 1), c.expected_last_direction) << c.beams;
  }
}

TEST(RangeInADirection, IsThatOfTheNearestBeamHoweverFarApartTheyAre) {
  const Scan scan = scanOf(message(7, -90, 30));
  const ScanGeometry geometry = geometryOf(scan, 100.0);
  for (int direction = 0; direction <= 90; ++direction) {
    if (direction % 15 == 7 || direction % 15 == 8) continue;  // half way
    const double metres = std::round(direction / 15.0) + 1.0;
    EXPECT_EQ(rangeIn(direction, scan, geometry), std::lround(metres / 100.0 * kNoReturn));
  }
  EXPECT_EQ(rangeIn(135, scan, geometry), -1) << "behind the robot";
}

TEST(RangeInADirection, IsUnknownWhereTheNearestBeamIsInvalid) {
  LaserScan taken = message(181, -90, 1);
  taken.ranges[60] = kNan;
  taken.ranges[120] = kInf;
  const Scan scan = scanOf(taken);
  const ScanGeometry geometry = geometryOf(scan, 10.0);
  EXPECT_EQ(rangeIn(30, scan, geometry), -1);
  EXPECT_EQ(rangeIn(60, scan, geometry), kNoReturn);
  EXPECT_EQ(rangeIn(0, scan, geometry), std::lround(25.5));
}

TEST(Directions, OfAnyScanAreInRange) {
  Rng rng(1);
  for (int n = 0; n < 3000; ++n) {
    LaserScan scan = message(static_cast<int>(1 + rng.below(400)), rng.uniform(-400, 400),
                             rng.uniform(-5.0, 5.0));
    const double far = std::pow(10.0, rng.uniform(-2.0, 6.0));
    for (float& range : scan.ranges) {
      const std::size_t kind = rng.below(10);
      range = kind == 0   ? kNan
              : kind == 1 ? kInf
                          : static_cast<float>(rng.uniform(-0.1, 1.0) * far);
    }
    const LaserMount mount{{rng.normal(), rng.normal()}, Eigen::Matrix2d::Random(), {}};
    const Scan taken = scanOf(scan, mount);
    const ScanGeometry geometry = geometryOf(taken, std::pow(10.0, rng.uniform(-1.0, 3.0)));
    ASSERT_GE(geometry.count, 1);
    ASSERT_LE(geometry.count, kDirections);
    const DirectionalScan beams = toDirections(taken, geometry);
    int valid = 0;
    for (const std::int16_t range : beams.range) {
      ASSERT_GE(range, -1);
      ASSERT_LE(range, kNoReturn);
      valid += range >= 0 ? 1 : 0;
    }
    ASSERT_EQ(beams.valid, valid);
    ASSERT_GE(geometry.beams(), 1);
    ASSERT_LE(geometry.beams(), kDirections);
    for (int direction = 0; direction < kDirections; ++direction) {
      const int range = rangeIn(direction, taken, geometry);
      ASSERT_GE(range, -1);
      ASSERT_LE(range, kNoReturn);
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
