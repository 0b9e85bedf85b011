// SPDX-License-Identifier: BSD-3-Clause
#include "sim/drive_base.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace adaptive_localization {
namespace {

constexpr double kStep = 0.01;

TEST(DriveBase, AcceleratesToTheLimitAndNoFaster) {
  DriveBase base{DriveBaseOptions{}};
  double before = 0.0;
  for (int i = 0; i < 300; ++i) {
    const double now = i * kStep;
    base.command({9.0, -9.0}, now);
    const Velocity velocity = base.step(now, kStep);
    EXPECT_LE(velocity.forward - before, 0.6 * kStep + 1e-12);
    before = velocity.forward;
  }
  EXPECT_DOUBLE_EQ(base.velocity().forward, 0.5);
  EXPECT_DOUBLE_EQ(base.velocity().turn, -1.745);
}

TEST(DriveBase, StopsWhenCommandsStayAway) {
  DriveBase base{DriveBaseOptions{}};
  base.command({0.3, 0.0}, 0.0);
  for (int i = 0; i <= 60; ++i) base.step(i * kStep, kStep);
  EXPECT_DOUBLE_EQ(base.velocity().forward, 0.3);
  for (int i = 61; i < 120; ++i) base.step(i * kStep, kStep);
  EXPECT_NEAR(base.velocity().forward, 0.0, 1e-12);
}

TEST(DriveBase, IgnoresACommandThatIsNoNumber) {
  DriveBase base{DriveBaseOptions{}};
  base.command({0.3, 0.0}, 0.0);
  base.command({std::numeric_limits<double>::quiet_NaN(), 0.0}, 0.0);
  for (int i = 0; i < 55; ++i) base.step(i * kStep, kStep);
  EXPECT_DOUBLE_EQ(base.velocity().forward, 0.3);
}

TEST(DriveBase, DrivesAsideOnlyWithFourWheels) {
  for (const std::string kind : {"differential", "omni"}) {
    DriveBaseOptions options;
    options.base = kind;
    DriveBase base(options);
    base.command({0.0, 0.0, -9.0}, 0.0);
    for (int i = 0; i < 55; ++i) base.step(i * kStep, kStep);
    EXPECT_NEAR(base.velocity().aside, kind == "omni" ? -0.33 : 0.0, 1e-9);
    base.stop();
    EXPECT_EQ(base.velocity().aside, 0.0);
  }
}

TEST(Arc, IsTheLimitOfManySmallSteps) {
  const Velocity velocity{0.4, 0.7};
  Pose2 fine;
  for (int i = 0; i < 100000; ++i) {
    fine = fine * Pose2{0.4 * 2e-5, 0.0, 0.7 * 2e-5};
  }
  const Pose2 exact = arc(velocity, 2.0);
  EXPECT_NEAR(exact.x, fine.x, 1e-5);
  EXPECT_NEAR(exact.y, fine.y, 1e-5);
  EXPECT_NEAR(exact.theta, fine.theta, 1e-9);
  EXPECT_DOUBLE_EQ(arc({0.4, 0.0}, 2.0).x, 0.8);

  Pose2 fine_aside;
  for (int i = 0; i < 100000; ++i) {
    fine_aside = fine_aside * Pose2{0.4 * 2e-5, -0.3 * 2e-5, 0.7 * 2e-5};
  }
  const Pose2 exact_aside = arc({0.4, 0.7, -0.3}, 2.0);
  EXPECT_NEAR(exact_aside.x, fine_aside.x, 1e-5);
  EXPECT_NEAR(exact_aside.y, fine_aside.y, 1e-5);
  EXPECT_DOUBLE_EQ(arc({0.0, 0.0, 0.4}, 2.0).y, 0.8);
}

}  // namespace
}  // namespace adaptive_localization
