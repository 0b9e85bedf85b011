// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/match/sonar_lines.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr double kView = 0.524;
constexpr double kReach = 5.0;

/// A straight wall without ends: where it is, in map.
struct Wall {
  double rho, alpha;

  Wall from(const Pose2& T_map_base) const {
    const Eigen::Vector2d normal(std::cos(alpha), std::sin(alpha));
    return {rho - normal.dot(Eigen::Vector2d(T_map_base.x, T_map_base.y)),
            wrapAngle(alpha - T_map_base.theta)};
  }
};

/// A robot with a sonar on each side and one ahead between two that look aside, on a drive.
class Drive {
 public:
  Drive(std::vector<Wall> walls, const LineOptions& options, std::uint64_t seed = 1)
      : walls_(std::move(walls)), options_(options), lines_(options), rng_(seed) {}

  void setNoise(double ranges, const Eigen::Vector3d& odometry) {
    range_noise_ = ranges;
    odometry_noise_ = odometry;
  }

  /// Moves by what odometry says, and a bit else.
  void move(const Pose2& motion) {
    const Eigen::Vector3d& s = odometry_noise_;
    truth_ = truth_ * Pose2{motion.x + rng_.normal(0.0, s.x()), motion.y + rng_.normal(0.0, s.y()),
                            motion.theta + rng_.normal(0.0, s.z())};
    lines_.move(motion, s.cwiseAbs2().asDiagonal());
  }

  /// All sonars hear the nearest wall that faces them.
  std::vector<SonarReading> readings() {
    std::vector<SonarReading> all;
    for (std::size_t i = 0; i < mounts().size(); ++i) {
      SonarReading reading{static_cast<int>(i), mounts()[i], kReach, kReach, kView};
      const Pose2 T_map_sonar = truth_ * mounts()[i];
      for (const Wall& wall : walls_) {
        const Wall seen = wall.from(T_map_sonar);
        if (std::abs(seen.alpha) < kView / 2) reading.range = std::min(reading.range, seen.rho);
      }
      const double deviation = options_.line_sonar_std + 0.01 * reading.range;
      if (reading.range < kReach) reading.range += range_noise_ * deviation * rng_.normal();
      all.push_back(reading);
    }
    return all;
  }

  std::vector<ScanLine> listen() {
    lines_.hear(readings());
    return lines_.takeLines();
  }

  /// The lines of so many steps, the last of which each is from.
  std::vector<ScanLine> drive(const Pose2& motion, int steps) {
    std::vector<ScanLine> all;
    for (int i = 0; i < steps && all.empty(); ++i) {
      move(motion);
      all = listen();
    }
    return all;
  }

  /// How far off a line is from a wall, in (rho, alpha).
  Eigen::Vector2d error(const ScanLine& line, std::size_t wall) const {
    const Wall seen = walls_[wall].from(truth_);
    return {line.rho - seen.rho, wrapAngle(line.alpha - seen.alpha)};
  }

  SonarLines& lines() { return lines_; }

 private:
  static const std::array<Pose2, 5>& mounts() {
    static const std::array<Pose2, 5> all{{{0.07, 0.14, kPi / 2},
                                           {0.15, 0.08, 0.2},
                                           {0.16, 0.0, 0.0},
                                           {0.15, -0.08, -0.2},
                                           {0.07, -0.14, -kPi / 2}}};
    return all;
  }

  std::vector<Wall> walls_;
  LineOptions options_;
  SonarLines lines_;
  Rng rng_;
  double range_noise_{0.0};
  Eigen::Vector3d odometry_noise_{0.0, 0.0, 0.0};
  Pose2 truth_;
};

const Wall kLeft{1.0, kPi / 2}, kRight{0.8, -kPi / 2}, kAhead{2.0, 0.0};
const Pose2 kStep{0.05, 0.0, 0.0};

double squareOf(const Eigen::Vector2d& error, const ScanLine& line) {
  return error.dot(line.covariance.inverse() * error);
}

TEST(SonarLines, AWallAlongTheWayIsWhereItIs) {
  Drive drive({kLeft}, {});
  const auto lines = drive.drive(kStep, 40);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_NEAR(drive.error(lines[0], 0).x(), 0.0, 1e-6);
  EXPECT_NEAR(drive.error(lines[0], 0).y(), 0.0, 1e-6);
  EXPECT_GT(lines[0].length(), 0.2);
  for (const Eigen::Vector2d& end : {lines[0].a, lines[0].b}) {
    EXPECT_NEAR(end.y(), 1.0, 1e-6);
    EXPECT_LT(end.x(), 0.1);
  }
}

TEST(SonarLines, AWallThatIsSlantedToTheSonarsIsToo) {
  for (const double slant : {-0.2, 0.1, 0.2}) {
    Drive drive({{1.2, kPi / 2 + slant}}, {});
    const auto lines = drive.drive(kStep, 40);
    ASSERT_THAT(lines, SizeIs(1)) << slant;
    EXPECT_LT(squareOf(drive.error(lines[0], 0), lines[0]), 0.3) << slant;
  }
}

/// Heard from nearly one place, whose ranges tell nothing of its direction.
TEST(SonarLines, AWallAheadIsNoLineBeforeTheRobotTurns) {
  Drive drive({kAhead}, {});
  ASSERT_THAT(drive.drive(kStep, 20), IsEmpty());
  std::vector<ScanLine> lines;
  for (int i = 0; i < 40 && lines.empty(); ++i) {
    lines = drive.drive({0.02, 0.0, i < 20 ? 0.08 : -0.08}, 1);
  }
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_LT(squareOf(drive.error(lines[0], 0), lines[0]), 0.5);
}

TEST(SonarLines, TwoWallsAreTwoLines) {
  Drive drive({kLeft, kRight}, {});
  const auto lines = drive.drive(kStep, 40);
  ASSERT_THAT(lines, SizeIs(2));
  const std::size_t left = lines[0].alpha > 0.0 ? 0 : 1;
  EXPECT_NEAR(drive.error(lines[left], 0).norm(), 0.0, 1e-6);
  EXPECT_NEAR(drive.error(lines[1 - left], 1).norm(), 0.0, 1e-6);
}

/// On a turn on the spot in a corner each wall is faced by one sonar after the other.
TEST(SonarLines, ACornerIsNoLine) {
  const std::vector<Wall> walls{{1.0, kPi / 2}, {1.2, 0.0}};
  Drive drive(walls, {});
  std::size_t count = 0;
  for (int i = 0; i < 60; ++i) {
    for (const ScanLine& line : drive.drive({0.02, 0.0, 0.05}, 1)) {
      ++count;
      const double off =
          std::min(squareOf(drive.error(line, 0), line), squareOf(drive.error(line, 1), line));
      EXPECT_LT(off, 1.0) << line.rho << ", " << line.alpha;
    }
  }
  EXPECT_GE(count, 3U);
}

TEST(SonarLines, TheCovarianceIsHonest) {
  constexpr int kSeeds = 1000;
  for (const bool has_odometry_noise : {false, true}) {
    double sum = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      Rng rng(seed);
      const double slant = rng.uniform(-kView / 2, kView / 2);
      Drive drive({{rng.uniform(0.8, 2.0), kPi / 2 + slant}}, {}, seed);
      drive.setNoise(
          1.0, has_odometry_noise ? Eigen::Vector3d(0.005, 0.005, 0.003) : Eigen::Vector3d::Zero());
      for (const ScanLine& line : drive.drive(kStep, 40)) {
        sum += squareOf(drive.error(line, 0), line);
        ++count;
      }
    }
    EXPECT_GT(count, 9 * kSeeds / 10);
    EXPECT_GT(sum / count, 1.6) << "of 2 degrees of freedom";
    EXPECT_LT(sum / count, 2.3) << has_odometry_noise;
  }
}

/// A fifth of the echoes are of anything.
TEST(SonarLines, OutliersAreNotOfALine) {
  int lines = 0, wrong = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Drive drive({kLeft, kRight}, {}, seed);
    drive.setNoise(1.0, Eigen::Vector3d::Zero());
    Rng rng(1000 + seed);
    for (int i = 0; i < 40; ++i) {
      drive.move(kStep);
      auto readings = drive.readings();
      for (SonarReading& reading : readings) {
        if (rng.uniform() < 0.2) reading.range = rng.uniform(0.1, 3.0);
      }
      drive.lines().hear(readings);
      for (const ScanLine& line : drive.lines().takeLines()) {
        ++lines;
        const double off =
            std::min(squareOf(drive.error(line, 0), line), squareOf(drive.error(line, 1), line));
        wrong += off > 13.8;
      }
    }
  }
  EXPECT_GT(lines, 300);
  EXPECT_LT(wrong, lines / 20);
}

TEST(SonarLines, EchoesMakeOneLineAndAreUsedUp) {
  Drive drive({kLeft}, {});
  ASSERT_THAT(drive.drive(kStep, 40), SizeIs(1));
  EXPECT_EQ(drive.lines().size(), 0U);
  EXPECT_THAT(drive.lines().takeLines(), IsEmpty());
}

TEST(SonarLines, ARobotThatStandsHearsNothingNew) {
  Drive drive({kLeft, kRight, kAhead}, {});
  for (int i = 0; i < 300; ++i) {
    drive.move({});
    ASSERT_THAT(drive.listen(), IsEmpty());
  }
  EXPECT_EQ(drive.lines().size(), 5U);
}

TEST(SonarLines, SilenceIsNoLine) {
  Drive drive({}, {});
  EXPECT_THAT(drive.drive(kStep, 100), IsEmpty());
  EXPECT_EQ(drive.lines().size(), 0U);
}

/// A wall on each side of a door: what is between is not of either.
TEST(SonarLines, NoLineGoesThroughADoor) {
  SonarLines lines{LineOptions{}};
  const auto hear = [&](int steps) {
    std::vector<ScanLine> all;
    for (int i = 0; i < steps; ++i) {
      lines.move(kStep, Eigen::Matrix3d::Zero());
      lines.hear({{0, {0.0, 0.0, kPi / 2}, 1.0, kReach, kView}});
      for (ScanLine& line : lines.takeLines()) all.push_back(line);
    }
    return all;
  };
  ASSERT_THAT(hear(3), IsEmpty());
  lines.move({1.0, 0.0, 0.0}, Eigen::Matrix3d::Zero());
  EXPECT_THAT(hear(3), IsEmpty());
  const auto beyond = hear(20);
  ASSERT_THAT(beyond, testing::Not(IsEmpty()));
  EXPECT_LT(beyond[0].length(), 1.0);
}

TEST(SonarLines, TheyRideOnTheOdometry) {
  Drive drive({kLeft}, {});
  const Pose2 motions[] = {{0.1, 0.02, 0.1}, {0.08, -0.03, -0.15}, {0.1, 0.0, 0.05}};
  std::vector<ScanLine> lines;
  for (int i = 0; i < 30 && lines.empty(); ++i) lines = drive.drive(motions[i % 3], 1);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_LT(squareOf(drive.error(lines[0], 0), lines[0]), 0.3);
}

TEST(SonarLines, WhatIsFarBehindIsForgotten) {
  Drive drive({kLeft}, {});
  drive.listen();
  EXPECT_EQ(drive.lines().size(), 1U);
  for (int i = 0; i < 31; ++i) drive.move({0.1, 0.0, 0.0});
  EXPECT_EQ(drive.lines().size(), 0U);
  drive.listen();
  for (int i = 0; i < 80; ++i) drive.move({0.0, 0.0, 0.1});
  EXPECT_EQ(drive.lines().size(), 0U) << "of turns too";
}

TEST(SonarLines, TheyAreSaneWhateverGoesIn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> odd{nan, inf, -inf, 0.0, -1.0, 1e-300, 1e3, 1e12, 1e300, 0.5, 2.0, 6.2};
  Rng rng(7);
  const auto any = [&] { return odd[static_cast<std::size_t>(rng.uniform() * 11.99)]; };
  const auto some = [&](double usual) { return rng.uniform() < 0.1 ? any() : usual; };
  SonarLines lines{LineOptions{}};
  std::size_t most = 0, count = 0;
  for (int i = 0; i < 5000; ++i) {
    Eigen::Matrix3d noise = Eigen::Vector3d(1e-5, 1e-5, 1e-6).asDiagonal();
    if (rng.uniform() < 0.02) noise(i % 3, i % 2) = any();
    Pose2 motion{0.02, 0.0, 0.01};
    if (rng.uniform() < 0.02) motion = {any(), any(), any()};
    lines.move(motion, noise);
    std::vector<SonarReading> readings;
    for (int k = 0; k < 8; ++k) {
      readings.push_back({k,
                          {some(0.1 * k), some(0.0), some(0.3 * k)},
                          some(rng.uniform(0.5, 0.6)),
                          some(5.0),
                          some(kView)});
    }
    lines.hear(readings);
    most = std::max(most, lines.size());
    for (const ScanLine& line : lines.takeLines()) {
      ++count;
      ASSERT_TRUE(std::isfinite(line.rho) && std::isfinite(line.alpha));
      ASSERT_TRUE(line.covariance.allFinite() && line.a.allFinite() && line.b.allFinite());
      ASSERT_GT(line.covariance.determinant(), 0.0);
    }
  }
  EXPECT_LE(most, 200U);
  EXPECT_GT(count, 100U);
}

}  // namespace
}  // namespace adaptive_localization
