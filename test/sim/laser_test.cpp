// SPDX-License-Identifier: BSD-3-Clause
#include "sim/laser.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace adaptive_localization {
namespace {

LaserOptions exact() {
  LaserOptions options;
  options.laser_noise = options.laser_bias = options.laser_resolution = 0.0;
  options.laser_mixed = options.laser_grazing = options.laser_short = options.laser_dazzle = 0.0;
  return options;
}

/// A round room: every ray from its centre is as long.
Laser::Caster roundRoom(double radius) {
  return [radius](const Pose2&, double limit) { return std::min(radius, limit); };
}

/// A wall across x = 3 up to y = 0 and one across x = 6 above it.
double twoWalls(const Pose2& ray, double limit) {
  const double c = std::cos(ray.theta);
  if (c <= 1e-9) return limit;
  const double near = (3.0 - ray.x) / c;
  const double range = ray.y + near * std::sin(ray.theta) < 0.0 ? near : (6.0 - ray.x) / c;
  return std::min(range, limit);
}

TEST(Laser, SendsTheBeamsOfAnLms291) {
  Laser laser(exact(), laserMounts(exact()).front(), Rng(1));
  const LaserScan scan = laser.scan({}, roundRoom(5.0));
  EXPECT_EQ(scan.ranges.size(), 181U);
  EXPECT_DOUBLE_EQ(scan.angle_min, -kPi / 2.0);
  EXPECT_NEAR(scan.angle_increment, kPi / 180.0, 1e-15);
  EXPECT_NEAR(scan.time_increment, 37.0e-6, 0.1e-6);
  EXPECT_DOUBLE_EQ(scan.range_max, 81.0);
  EXPECT_THAT(scan.ranges, testing::Each(5.0F));
}

TEST(Laser, SeesAsFarAroundAsItIsTold) {
  LaserOptions options = exact();
  options.laser_view = 270.0;
  options.laser_beams = 271;
  Laser laser(options, laserMounts(options).front(), Rng(1));
  const LaserScan scan = laser.scan({}, roundRoom(5.0));
  EXPECT_EQ(scan.ranges.size(), 271U);
  EXPECT_DOUBLE_EQ(scan.angle_min, -0.75 * kPi);
  EXPECT_NEAR(scan.angle_increment, kPi / 180.0, 1e-15);
}

TEST(Laser, HasATwinOnTheOtherCornerOfTheRobot) {
  LaserOptions options;
  options.laser_x = 0.2;
  options.laser_y = 0.15;
  options.laser_yaw = kPi / 4.0;
  EXPECT_EQ(laserMounts(options).size(), 1U);
  options.lasers = 2;
  const auto mounts = laserMounts(options);
  ASSERT_EQ(mounts.size(), 2U);
  EXPECT_NEAR(mounts[1].x, -0.2, 1e-12);
  EXPECT_NEAR(mounts[1].y, -0.15, 1e-12);
  EXPECT_NEAR(wrapAngle(mounts[1].theta - (kPi / 4.0 - kPi)), 0.0, 1e-12);
}

TEST(Laser, AlternatesHalfScansWhenInterlaced) {
  LaserOptions options = exact();
  options.laser_interlaced = true;
  Laser laser(options, laserMounts(options).front(), Rng(1));
  for (int round = 0; round < 3; ++round) {
    const LaserScan whole = laser.scan({}, roundRoom(5.0));
    const LaserScan half = laser.scan({}, roundRoom(5.0));
    EXPECT_EQ(whole.ranges.size(), 181U);
    EXPECT_EQ(half.ranges.size(), 180U);
    EXPECT_NEAR(half.angle_min * 180.0 / kPi, -89.5, 1e-9);
    EXPECT_NEAR(half.angle_increment, kPi / 180.0, 1e-15);
  }
}

TEST(Laser, SitsWhereItIsMounted) {
  Laser laser(exact(), laserMounts(exact()).front(), Rng(1));
  const LaserScan scan = laser.scan({1.0, -2.0, 0.0}, twoWalls);
  EXPECT_NEAR(scan.ranges[90], 3.0 - 1.021, 1e-6);
}

TEST(Laser, SendsItsBeamsOneAfterTheOtherFromARobotThatMoves) {
  Laser laser(exact(), laserMounts(exact()).front(), Rng(1));
  const double seconds = 0.25 / 75.0;  // a quarter of a turn, to the middle beam
  const LaserScan ahead = laser.scan({-0.021, -2.0, 0.0}, twoWalls, {0.8, 0.0});
  EXPECT_NEAR(ahead.ranges[90], 3.0 - 0.8 * seconds, 1e-6);
  const LaserScan turning = laser.scan({-0.021, -2.0, 0.0}, twoWalls, {0.0, 1.0});
  EXPECT_NEAR(turning.ranges[60] * std::cos(-kPi / 6.0 + 60 * turning.time_increment), 3.0, 1e-3);
  EXPECT_GT(std::abs(turning.ranges[60] * std::cos(kPi / 6.0) - 3.0), 2e-3) << "it shows";
}

TEST(Laser, NoiseBiasAndRoundingAreThoseGiven) {
  LaserOptions options = exact();
  options.laser_noise = 0.010;
  options.laser_bias = 0.035;
  options.laser_resolution = 0.01;
  double sum_of_biases = 0.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Laser laser(options, laserMounts(options).front(), Rng(seed));
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kScans = 20;
    for (int i = 0; i < kScans; ++i) {
      for (const double range : laser.scan({}, roundRoom(5.0)).ranges) {
        ASSERT_NEAR(range * 100.0, std::nearbyint(range * 100.0), 1e-4);
        sum += range - 5.0;
        squares += (range - 5.0) * (range - 5.0);
      }
    }
    const double count = 181.0 * kScans;
    const double bias = sum / count;
    EXPECT_LE(std::abs(bias), 0.036);
    EXPECT_NEAR(std::sqrt(squares / count - bias * bias), std::hypot(0.010, 0.01 / std::sqrt(12.0)),
                0.0015);
    sum_of_biases += std::abs(bias);
  }
  EXPECT_NEAR(sum_of_biases / 50.0, 0.0175, 0.006);
}

TEST(Laser, SaysWhatItCannotMeasure) {
  LaserOptions options = exact();
  Laser far(options, laserMounts(options).front(), Rng(1));
  EXPECT_THAT(far.scan({}, roundRoom(100.0)).ranges, testing::Each(INFINITY));
  options.laser_max_range = 8.0;
  Laser millimetres(options, laserMounts(options).front(), Rng(1));
  const LaserScan scan = millimetres.scan({}, roundRoom(9.0));
  EXPECT_THAT(scan.ranges, testing::Each(INFINITY));
  EXPECT_NEAR(scan.range_max, 8.1, 1e-9);

  options.laser_dazzle = 0.1;
  Laser dazzled(options, laserMounts(options).front(), Rng(1));
  int invalid = 0;
  for (int i = 0; i < 20; ++i) {
    for (const float range : dazzled.scan({}, roundRoom(5.0)).ranges) invalid += std::isnan(range);
  }
  EXPECT_NEAR(invalid, 362, 60);
}

TEST(Laser, BeamsSplitByAnEdgeReturnWhatIsBetween) {
  LaserOptions options = exact();
  options.laser_mixed = 1.0;
  Laser laser(options, laserMounts(options).front(), Rng(1));
  int between = 0;
  for (int i = 0; i < 50; ++i) {
    const float range = laser.scan({}, twoWalls).ranges[90];  // straight at the edge
    EXPECT_GE(range, 2.97F);
    EXPECT_LE(range, 5.98F);
    if (range > 3.1F && range < 5.9F) ++between;
  }
  EXPECT_GT(between, 40);
}

TEST(Laser, LosesSomeBeamsThatGrazeASurface) {
  LaserOptions options = exact();
  options.laser_grazing = 1.0;
  Laser laser(options, laserMounts(options).front(), Rng(1));
  const auto wall = [](const Pose2& ray, double limit) {  // along y = 1
    const double s = std::sin(ray.theta);
    return s > 1e-9 ? std::min((1.0 - ray.y) / s, limit) : limit;
  };
  const auto ranges = laser.scan({}, wall).ranges;
  EXPECT_TRUE(std::isnan(ranges[95]));    // 5 degrees off the wall's direction
  EXPECT_FALSE(std::isnan(ranges[110]));  // 20 degrees
}

TEST(Laser, ShortReadingsAreAsOftenAsAskedFor) {
  LaserOptions options = exact();
  options.laser_short = 0.2;
  Laser laser(options, laserMounts(options).front(), Rng(1));
  int shorter = 0;
  for (int i = 0; i < 20; ++i) {
    for (const float range : laser.scan({}, roundRoom(5.0)).ranges) shorter += range < 5.0F;
  }
  EXPECT_NEAR(shorter, 724, 80);
}

class ALaserAmongReflectors : public testing::Test {
 protected:
  ALaserAmongReflectors() {
    options_.laser_x = options_.laser_intensity_noise = options_.laser_glare = 0.0;
  }

  LaserScan scan(const Laser::Caster& cast = roundRoom(5.0), std::uint64_t seed = 1) const {
    return Laser(options_, laserMounts(options_).front(), Rng(seed), landmarks_).scan({}, cast);
  }

  LaserOptions options_{exact()};
  // straight ahead, 30 degrees to the left on the wall and before it, and what is no reflector
  std::vector<Landmark> landmarks_{{0, {5.0, 0.0}, 0.2},
                                   {0, {4.0 * std::cos(kPi / 6), 4.0 * std::sin(kPi / 6)}, 0.2},
                                   {0, {0.0, 5.0}}};
};

TEST_F(ALaserAmongReflectors, SeesThemBrightAsWideAsTheyAreAndItsSpot) {
  const LaserScan bright = scan();
  ASSERT_EQ(bright.intensities.size(), bright.ranges.size());
  // half of 0.2 m and half a spot at 5 m: 1.15 and 0.37 degrees on each side
  for (std::size_t i = 0; i < bright.intensities.size(); ++i) {
    EXPECT_EQ(bright.intensities[i], i >= 89 && i <= 91 ? 200.0F : 40.0F) << i;
  }
}

TEST_F(ALaserAmongReflectors, SeesThemNotBehindOrBeforeWhatItsBeamEndsOn) {
  EXPECT_THAT(scan(roundRoom(4.7)).intensities, testing::Each(40.0F));
  const auto ahead = scan(roundRoom(4.0)).intensities;
  EXPECT_EQ(ahead[90], 40.0F);
  EXPECT_EQ(ahead[120], 200.0F) << "the wall is where the second one is";
}

TEST_F(ALaserAmongReflectors, SeesNothingBrightWhereABeamIsShortOrLost) {
  options_.laser_short = 1.0;
  EXPECT_THAT(scan().intensities, testing::Each(40.0F));
  options_.laser_short = 0.0;
  EXPECT_THAT(scan(roundRoom(100.0)).intensities, testing::Each(0.0F));
}

TEST_F(ALaserAmongReflectors, HasGlareAndNoiseAsAskedFor) {
  options_.laser_glare = 0.1;
  options_.laser_intensity_noise = 10.0;
  int bright = 0;
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (const double intensity : scan(roundRoom(4.7), seed).intensities) {
      bright += intensity > 120.0;
      squares += std::pow(intensity - (intensity > 120.0 ? 200.0 : 40.0), 2);
    }
  }
  EXPECT_NEAR(bright, 905, 90);
  EXPECT_NEAR(std::sqrt(squares / (181.0 * 50.0)), 10.0, 0.5);
}

TEST_F(ALaserAmongReflectors, HasTheRangesOfOneAmongNoneWhichHasNoIntensities) {
  options_ = LaserOptions();
  const LaserScan with = scan();
  landmarks_.clear();
  const LaserScan without = scan();
  ASSERT_EQ(with.ranges.size(), without.ranges.size());
  for (std::size_t i = 0; i < with.ranges.size(); ++i) {
    const bool both_invalid = std::isnan(with.ranges[i]) && std::isnan(without.ranges[i]);
    EXPECT_TRUE(both_invalid || with.ranges[i] == without.ranges[i]) << i;
  }
  EXPECT_THAT(without.intensities, testing::IsEmpty());
}

}  // namespace
}  // namespace adaptive_localization
