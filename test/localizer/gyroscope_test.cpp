// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/gyroscope.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

class ARobotWithAGyroscope : public testing::Test {
 protected:
  /// Lets so many scans of 0.1 s pass in which the wheels tell a motion and the gyroscope a rate;
  /// the motion of all, as corrected.
  Pose2 drive(int scans, const Pose2& by_wheels, double rate) {
    Pose2 sum;
    for (int i = 0; i < scans; ++i) {
      stamp_ += 0.1;
      T_odom_base_ = T_odom_base_ * by_wheels;
      angle_ += 0.1 * rate;
      Observations observations;
      observations.stamp = stamp_;
      observations.gyro = GyroTurn{angle_, 0.01, since_};
      gyroscope_.observe(T_odom_base_, observations);
      sum = sum * by_wheels * gyroscope_.slipDuring(by_wheels);
    }
    return sum;
  }

  Gyroscope gyroscope_;
  Pose2 T_odom_base_;
  double stamp_{100.0}, angle_{0.0}, since_{99.0};
};

TEST_F(ARobotWithAGyroscope, TurnsAsItTellsWhereWheelsSlip) {
  drive(1, {}, 0.0);
  const Pose2 motion = drive(10, {0.02, 0.0, 0.10}, 0.9);  // wheels say 1 rad, it was 0.9
  EXPECT_NEAR(motion.theta, 0.9, 0.01);
  EXPECT_EQ(gyroscope_.state(), "used");
}

TEST_F(ARobotWithAGyroscope, DrivesAnArcWhereWheelsTellALine) {
  drive(1, {}, 0.0);
  const Pose2 motion = drive(1, {0.1, 0.0, 0.0}, 1.0);
  EXPECT_NEAR(motion.theta, 0.1, 0.01);
  EXPECT_NEAR(motion.y, 0.1 * 0.05, 0.001);
}

TEST_F(ARobotWithAGyroscope, LearnsTheBiasWhileItStands) {
  drive(100, {}, 0.03);
  EXPECT_NEAR(gyroscope_.bias(), 0.03, 1e-9);
  const Pose2 motion = drive(20, {0.1, 0.0, 0.0}, 0.03);
  EXPECT_NEAR(motion.theta, 0.0, 1e-6);
}

TEST_F(ARobotWithAGyroscope, DoesNotTakeATurnByHandForABias) {
  drive(100, {}, 0.5);
  EXPECT_EQ(gyroscope_.bias(), 0.0);
}

TEST_F(ARobotWithAGyroscope, KeepsToItsWheelsWhereTheGyroscopeIsBroken) {
  drive(1, {}, 0.0);
  const Pose2 motion = drive(50, {0.0, 0.0, 0.1}, 0.0);
  EXPECT_TRUE(gyroscope_.isDoubted());
  EXPECT_EQ(gyroscope_.state(), "contradicts the odometry");
  EXPECT_NEAR(wrapAngle(motion.theta - 5.0), 0.0, 0.3);
  drive(100, {0.05, 0.0, 0.0}, 0.0);
  EXPECT_FALSE(gyroscope_.isDoubted());
}

TEST_F(ARobotWithAGyroscope, HasNoSlipWhereSumsBeganAnew) {
  drive(5, {0.1, 0.0, 0.0}, 0.0);
  since_ = stamp_;
  angle_ = 17.0;
  const Pose2 motion = drive(1, {0.1, 0.0, 0.0}, 0.0);
  EXPECT_EQ(motion.theta, 0.0);
}

TEST_F(ARobotWithAGyroscope, WithoutOneMotionsStayAsTheyAre) {
  gyroscope_.observe({1.0, 2.0, 0.3}, {});
  const Pose2 slip = gyroscope_.slipDuring({0.1, 0.0, 0.2});
  EXPECT_EQ(slip.x, 0.0);
  EXPECT_EQ(slip.y, 0.0);
  EXPECT_EQ(slip.theta, 0.0);
}

}  // namespace
}  // namespace adaptive_localization
