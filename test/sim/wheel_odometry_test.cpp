// SPDX-License-Identifier: BSD-3-Clause
#include "sim/wheel_odometry.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace adaptive_localization {
namespace {

constexpr double kStep = 0.01;

OdometryOptions exact() {
  return OdometryOptions::profile("ideal");
}

Pose2 drive(const OdometryOptions& options, const Velocity& velocity, double seconds,
            std::uint64_t seed = 1) {
  WheelOdometry odometry(options, false, Rng(seed));
  const int steps = static_cast<int>(seconds / kStep + 0.5);
  for (int i = 0; i < steps; ++i) odometry.step(velocity, kStep);
  return odometry.pose();
}

TEST(WheelOdometry, TheIdealOneIsTheTruth) {
  const Velocity velocity{0.4, 0.3};
  const Pose2 pose = drive(exact(), velocity, 20.0);
  const Pose2 truth = arc(velocity, 20.0);
  EXPECT_NEAR(pose.x, truth.x, 1e-9);
  EXPECT_NEAR(pose.y, truth.y, 1e-9);
  EXPECT_NEAR(wrapAngle(pose.theta - truth.theta), 0.0, 1e-9);
}

TEST(WheelOdometry, AWrongAxleScalesTurns) {
  OdometryOptions options = exact();
  options.odom_axle_ratio = 1.02;
  EXPECT_NEAR(drive(options, {0.0, 0.5}, 4.0).theta, 2.0 * 1.02, 1e-9);
  EXPECT_NEAR(drive(options, {0.5, 0.0}, 4.0).x, 2.0, 1e-9);
}

TEST(WheelOdometry, UnequalWheelsBendAStraightLine) {
  OdometryOptions options = exact();
  options.odom_wheel_ratio = 1.004;
  const double expected = (1.0 / 1.002 - 1.0 / 0.998) * 3.0 / options.odom_axle;
  EXPECT_NEAR(drive(options, {0.5, 0.0}, 6.0).theta, expected, 1e-9);
}

TEST(WheelOdometry, NoiseHasTheVarianceItIsGiven) {
  OdometryOptions options = exact();
  options.odom_wheel_noise = 1e-4;
  const double metres = 2.0;
  double heading2 = 0.0;
  double along2 = 0.0;
  constexpr int kRuns = 2000;
  for (int run = 0; run < kRuns; ++run) {
    WheelOdometry odometry(options, false, Rng(static_cast<std::uint64_t>(run)));
    double along = 0.0;
    double heading = 0.0;
    for (int i = 0; i < 400; ++i) {
      odometry.step({0.5, 0.0}, kStep);
      along += odometry.velocity().forward * kStep;
      heading += odometry.velocity().turn * kStep;
    }
    heading2 += heading * heading / kRuns;
    along2 += (along - metres) * (along - metres) / kRuns;
  }
  // Both wheels independent: var(along) = k s / 2, var(heading) = 2 k s / axle^2.
  EXPECT_NEAR(along2, 1e-4 * metres / 2.0, 1e-5);
  const double axle = options.odom_axle;
  EXPECT_NEAR(heading2, 2.0 * 1e-4 * metres / (axle * axle), 2e-4);
}

TEST(WheelOdometry, SlippingWheelsSeeMoreTurnThanThereIs) {
  OdometryOptions options = exact();
  options.odom_slip_rate = 100.0;  // slips nearly always
  options.odom_slip_share = 0.5;
  WheelOdometry odometry(options, false, Rng(1));
  double turned = 0.0;
  for (int i = 0; i < 200; ++i) {
    odometry.step({0.0, 1.0}, kStep);
    turned += odometry.velocity().turn * kStep;
  }
  EXPECT_NEAR(turned, 4.0, 0.2);
  EXPECT_NEAR(drive(options, {0.0, 0.2}, 5.0).theta, 1.0, 1e-9);  // too slow to slip
}

TEST(WheelOdometry, ReportsWholeDegreesAndWaysOfWholeMillimetres) {
  OdometryOptions options = exact();
  options.odom_whole_degrees = true;
  WheelOdometry odometry(options, false, Rng(1));
  double way = 0.0, most_way = 0.0;  // of odometry and truth apart, m
  for (int i = 1; i <= 5000; ++i) {
    odometry.step({0.033, 0.01}, kStep);
    const Pose2 truth = arc({0.033, 0.01}, i * kStep);
    if (i % 10 != 0) continue;
    odometry.report();
    const Pose2 pose = odometry.pose();
    const double degrees = pose.theta * 180.0 / kPi;
    ASSERT_NEAR(degrees, std::nearbyint(degrees), 1e-9);
    ASSERT_NEAR(pose.x * 1000.0, std::nearbyint(pose.x * 1000.0), 1e-6);
    ASSERT_NEAR(degrees, truth.theta * 180.0 / kPi, 0.5 + 1e-6);
    way = std::abs(pose.x - truth.x);
    most_way = std::max(most_way, way);
  }
  EXPECT_GT(most_way, 0.002);        // errors of reports add up
  EXPECT_LT(most_way, 500 * 0.001);  // each at most half a millimetre, and half a count twice
}

TEST(WheelOdometry, GoesOnBetweenReports) {
  OdometryOptions options = exact();
  options.odom_whole_degrees = true;
  WheelOdometry odometry(options, false, Rng(1));
  for (int i = 0; i < 57; ++i) odometry.step({0.4, 0.0}, kStep);
  odometry.report();
  const Pose2 reported = odometry.pose();
  EXPECT_NEAR(reported.x, 0.228, 1e-9);
  for (int i = 0; i < 3; ++i) odometry.step({0.4, 0.0}, kStep);
  EXPECT_NEAR(odometry.pose().x - reported.x, 0.012, 1e-9);
  EXPECT_NEAR(odometry.pose(0.005).x - reported.x, 0.014, 1e-9);
}

TEST(WheelOdometry, FourWheelsWithRollersSeeWaysAsideToo) {
  OdometryOptions options = exact();
  const Velocity velocity{0.3, 0.2, -0.25};
  WheelOdometry odometry(options, true, Rng(1));
  for (int i = 0; i < 500; ++i) odometry.step(velocity, kStep);
  const Pose2 truth = arc(velocity, 5.0);
  EXPECT_NEAR(odometry.pose().x, truth.x, 1e-9);
  EXPECT_NEAR(odometry.pose().y, truth.y, 1e-9);
  EXPECT_NEAR(odometry.pose().theta, truth.theta, 1e-9);

  options.odom_axle_ratio = 1.02;
  WheelOdometry wrong(options, true, Rng(1));
  for (int i = 0; i < 500; ++i) wrong.step(velocity, kStep);
  EXPECT_NEAR(wrong.pose().theta, 1.02 * truth.theta, 1e-9);

  options = exact();
  options.odom_wheel_noise = 1e-4;
  double along2 = 0.0, aside2 = 0.0;
  for (int run = 0; run < 2000; ++run) {
    WheelOdometry noisy(options, true, Rng(static_cast<std::uint64_t>(run)));
    double along = -2.0, aside = 0.0;
    for (int i = 0; i < 400; ++i) {
      noisy.step({0.5, 0.0, 0.0}, kStep);
      along += noisy.velocity().forward * kStep;
      aside += noisy.velocity().aside * kStep;
    }
    along2 += along * along / 2000.0;
    aside2 += aside * aside / 2000.0;
  }
  EXPECT_NEAR(along2, 1e-4 * 2.0 / 4.0, 5e-6);  // the mean of four wheels
  EXPECT_NEAR(aside2, 1e-4 * 2.0 / 4.0, 5e-6);
}

TEST(WheelOdometry, ProfilesGetWorse) {
  const auto spread = [](const std::string& profile) {
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const Velocity velocity{0.4, 0.5};
      sum += distance(drive(OdometryOptions::profile(profile), velocity, 30.0, seed),
                      arc(velocity, 30.0));
    }
    return sum / 100.0;
  };
  EXPECT_LT(spread("ideal"), 1e-6);
  EXPECT_GT(spread("nominal"), 0.1);
  EXPECT_GT(spread("bad"), 1.5 * spread("nominal"));
  EXPECT_THROW(OdometryOptions::profile("perfect"), std::invalid_argument);
}

}  // namespace
}  // namespace adaptive_localization
