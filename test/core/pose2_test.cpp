// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/core/pose2.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

constexpr double kTolerance = 1e-9;

TEST(WrapAngle, KeepsPlusPiAndTurnsMinusPiIntoIt) {
  EXPECT_DOUBLE_EQ(wrapAngle(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrapAngle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(wrapAngle(3.0 * kPi), kPi);
  EXPECT_DOUBLE_EQ(wrapAngle(-3.0 * kPi), kPi);
}

TEST(WrapAngle, IsTheRepresentativeInTheHalfOpenTurn) {
  Rng rng(1);
  for (int i = 0; i < 10000; ++i) {
    const double angle = rng.uniform(-100.0, 100.0);
    const double wrapped = wrapAngle(angle);
    ASSERT_GT(wrapped, -kPi);
    ASSERT_LE(wrapped, kPi);
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle), kTolerance);
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle), kTolerance);
  }
}

TEST(Pose2, ComposesAsTransformsDo) {
  const Pose2 ahead{1.0, 0.0, kPi / 2};
  EXPECT_THAT((Pose2{2.0, 3.0, kPi / 2} * ahead), PoseNear(Pose2{2.0, 4.0, kPi}, 1e-12, 1e-12));
  EXPECT_TRUE((ahead * Eigen::Vector2d(1.0, 0.0)).isApprox(Eigen::Vector2d(1.0, 1.0)));
}

TEST(Pose2, ObeysTheGroupLaws) {
  Rng rng(2);
  for (int i = 0; i < 2000; ++i) {
    const Pose2 a = randomPose(rng, 50.0);
    const Pose2 b = randomPose(rng, 50.0);
    const Pose2 c = randomPose(rng, 50.0);
    ASSERT_THAT((a * b) * c, PoseNear(a * (b * c), kTolerance, kTolerance));
    ASSERT_THAT(a * Pose2{}, PoseNear(a, kTolerance, kTolerance));
    ASSERT_THAT(Pose2{} * a, PoseNear(a, kTolerance, kTolerance));
    ASSERT_THAT(a * inverse(a), PoseNear(Pose2{}, kTolerance, kTolerance));
    ASSERT_THAT(inverse(a) * a, PoseNear(Pose2{}, kTolerance, kTolerance));
    ASSERT_THAT(a * between(a, b), PoseNear(b, kTolerance, kTolerance));
  }
}

TEST(Pose2, MovesPointsAsItMovesPoses) {
  Rng rng(3);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 a = randomPose(rng, 50.0);
    const Pose2 b = randomPose(rng, 50.0);
    const Eigen::Vector2d moved = a * Eigen::Vector2d(b.x, b.y);
    ASSERT_THAT(a * b, PoseNear(Pose2{moved.x(), moved.y(), a.theta + b.theta}, 1e-12, 1e-12));
    ASSERT_NEAR(distance(a * b, a), std::hypot(b.x, b.y), kTolerance);
  }
}

TEST(Pose2, IsFiniteOnlyIfAllItsNumbersAre) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(isFinite({1.0, 2.0, 3.0}));
  EXPECT_FALSE(isFinite({nan, 0.0, 0.0}));
  EXPECT_FALSE(isFinite({0.0, -inf, 0.0}));
  EXPECT_FALSE(isFinite({0.0, 0.0, nan}));
}

}  // namespace
}  // namespace adaptive_localization
