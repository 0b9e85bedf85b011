// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/compass.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

CompassOptions offsetOf(double offset, double deviation) {
  CompassOptions options;
  options.heading_offset = offset;
  options.heading_offset_std = deviation;
  return options;
}

/// Drives so far with a compass that tells yaw - offset, and turns on the way.
void drive(Compass& compass, double offset, double way) {
  constexpr double kStep = 0.1;
  for (double driven = 0.0; driven < way; driven += kStep) {
    const double yaw = wrapAngle(0.3 * driven);
    compass.compare({wrapAngle(yaw - offset), 0.05}, yaw, 1e-4, kStep);
  }
}

TEST(Compass, AddsItsOffsetAndTheVarianceOfThat) {
  const Compass compass(offsetOf(0.5, 0.3));
  const auto heading = compass.inMap(Heading{3.0, 0.4});
  ASSERT_TRUE(heading);
  EXPECT_NEAR(heading->theta, wrapAngle(3.5), 1e-12);
  EXPECT_NEAR(heading->deviation, 0.5, 1e-12);
  EXPECT_FALSE(compass.inMap(std::nullopt));
}

TEST(Compass, TellsNothingBeforeItsOffsetIsLearned) {
  Compass compass;
  EXPECT_FALSE(compass.inMap(Heading{0.0, 0.1}));
  EXPECT_EQ(compass.state(), "offset not learned yet");
  drive(compass, -2.5, 3.0);
  ASSERT_TRUE(compass.inMap(Heading{0.0, 0.01}));
  EXPECT_NEAR(compass.inMap(Heading{0.0, 0.01})->theta, -2.5, 0.02);
  EXPECT_LT(compass.inMap(Heading{0.0, 0.01})->deviation, 0.1);
  EXPECT_EQ(compass.state(), "used");
}

TEST(Compass, LearnsNothingWhileTheRobotStands) {
  Compass compass;
  for (int i = 0; i < 1000; ++i) compass.compare({0.0, 0.05}, 1.0, 1e-4, 0.0);
  EXPECT_FALSE(compass.isKnown());
}

TEST(Compass, IsNotHeardWhileDisturbedAndKeepsItsOffset) {
  Compass compass(offsetOf(0.0, 0.2));
  drive(compass, 0.1, 5.0);
  drive(compass, 0.1 + kPi / 2, 1.0);
  EXPECT_TRUE(compass.isDisturbed());
  EXPECT_EQ(compass.state(), "disturbed");
  EXPECT_FALSE(compass.inMap(Heading{0.0, 0.1}));
  drive(compass, 0.1 + kPi / 2, 20.0);
  EXPECT_NEAR(compass.offset(), 0.1, 0.02);
  drive(compass, 0.1, 0.1);
  EXPECT_TRUE(compass.isDisturbed()) << "one reading proves nothing";
  drive(compass, 0.1, 1.0);
  ASSERT_TRUE(compass.inMap(Heading{0.0, 0.1}));
  EXPECT_NEAR(compass.inMap(Heading{0.0, 0.1})->theta, 0.1, 0.02);
}

TEST(Compass, OneReadingOffDisturbsNothing) {
  Compass compass(offsetOf(0.0, 0.05));
  compass.compare({kPi, 0.05}, 0.0, 1e-4, 0.1);
  EXPECT_FALSE(compass.isDisturbed());
}

TEST(Compass, TakesAnotherOffsetThatLastsForTheTrueOne) {
  Compass compass(offsetOf(0.0, 0.05));
  drive(compass, 1.0, 29.0);
  EXPECT_NEAR(compass.offset(), 0.0, 1e-9);
  drive(compass, 1.0, 3.0);
  EXPECT_NEAR(compass.offset(), 1.0, 0.02);
  EXPECT_FALSE(compass.isDisturbed());
}

TEST(Compass, AWanderingDisturbanceIsNoOffset) {
  Compass compass(offsetOf(0.0, 0.05));
  for (int i = 0; i < 10; ++i) drive(compass, i % 2 == 0 ? 1.0 : 2.5, 9.0);
  EXPECT_TRUE(compass.isDisturbed());
  EXPECT_NEAR(compass.offset(), 0.0, 1e-9);
}

TEST(Compass, ForgetsWhatItLearned) {
  Compass compass(offsetOf(0.4, 0.3));
  drive(compass, 0.7, 5.0);
  EXPECT_NEAR(compass.offset(), 0.7, 0.02);
  compass.configure(offsetOf(0.4, 0.3));
  EXPECT_NEAR(compass.offset(), 0.7, 0.02);
  compass.reset();
  EXPECT_EQ(compass.offset(), 0.4);
  compass.configure(offsetOf(0.1, 0.3));
  EXPECT_EQ(compass.offset(), 0.1);
}

}  // namespace
}  // namespace adaptive_localization
