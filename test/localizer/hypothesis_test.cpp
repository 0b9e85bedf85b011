// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/hypothesis.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

const Pose2 kStart{1.0, 2.0, 0.5};

Hypothesis after(const Pose2& motion) {
  Hypothesis hypothesis{kStart};
  hypothesis.ride(motion);
  return hypothesis;
}

TEST(Hypothesis, WheelsThatSpinLeaveItAnywhereOnItsWay) {
  const Hypothesis rolled = after({0.4, 0.0, 0.0});
  for (const double way : {0.0, 0.1, 0.4}) {
    EXPECT_NEAR(rolled.shiftTo(kStart * Pose2{way, 0.0, 0.0}), 0.0, 1e-9) << way;
    EXPECT_NEAR(rolled.shiftTo(kStart * Pose2{way, 0.21, 0.0}), 0.5, 1e-9) << way;
  }
}

/// 0.3 m, and by 0.3 of the way.
TEST(Hypothesis, WheelsSlipOnlySoFarOffTheirWay) {
  EXPECT_NEAR(after({}).shiftTo(kStart * Pose2{0.0, 0.3, 0.0}), 1.0, 1e-9);
  const Hypothesis rolled = after({0.4, 0.0, 0.0});
  EXPECT_NEAR(rolled.shiftTo(kStart * Pose2{0.4 + 0.42, 0.0, 0.0}), 1.0, 1e-9) << "ahead";
  EXPECT_NEAR(rolled.shiftTo(kStart * Pose2{-0.42, 0.0, 0.0}), 1.0, 1e-9) << "behind";
  EXPECT_NEAR(rolled.shiftTo(kStart * Pose2{0.2, -0.84, 0.0}), 2.0, 1e-9) << "beside";
  const Hypothesis turned = after({0.0, 0.0, 0.5});
  EXPECT_NEAR(turned.shiftTo(kStart * Pose2{0.0, 0.4, 0.0}), 1.0, 1e-9) << "in a turn";
}

/// 0.25 rad, and by as much as they turned it.
TEST(Hypothesis, WheelsTurnItOnlySoFar) {
  EXPECT_NEAR(after({}).slideTo(kStart * Pose2{0.0, 0.0, -0.25}), 1.0, 1e-9);
  const Hypothesis turned = after({0.0, 0.0, 0.4});
  EXPECT_NEAR(turned.slideTo(kStart * Pose2{0.0, 0.0, 0.4 + 0.65}), 1.0, 1e-9);
  EXPECT_NEAR(turned.slideTo(kStart * Pose2{0.0, 0.0, 0.4 - 1.3}), 2.0, 1e-9);
  EXPECT_NEAR(turned.slideTo(kStart * Pose2{0.0, 0.38, 0.4}), 1.0, 1e-9) << "the larger of both";
}

TEST(Hypothesis, WhatItMovedByCountsForHalfAMetreOrRadian) {
  const Pose2 aligned = kStart * Pose2{0.6, 0.4, 0.0};
  for (const Pose2& motion : {Pose2{0.6, 0.0, 0.0}, Pose2{0.0, 0.0, 0.6}}) {
    Hypothesis hypothesis = after(motion);
    hypothesis.settleAt({aligned, 0.01}, true);
    EXPECT_GT(hypothesis.shiftTo(aligned), 0.5);
    hypothesis.ride({});
    EXPECT_NEAR(hypothesis.shiftTo(aligned), 0.0, 1e-9);
    EXPECT_NEAR(hypothesis.shiftTo(aligned * Pose2{0.3, 0.0, 0.0}), 1.0, 1e-9);
  }
}

TEST(Hypothesis, RollsOnFromWhereItIsKnownToBe) {
  Hypothesis hypothesis = after({0.4, 0.0, 0.0});
  const Pose2 known = kStart * Pose2{0.4, 0.1, 0.1};
  hypothesis.rollFrom(known);
  EXPECT_NEAR(hypothesis.slideTo(known), 0.0, 1e-9);
  EXPECT_NEAR(hypothesis.slideTo(known * Pose2{0.0, 0.3, 0.0}), 1.0, 1e-9);
  EXPECT_NEAR(distance(hypothesis.T_map_base, kStart), 0.4, 1e-9) << "it stays";
}

}  // namespace
}  // namespace adaptive_localization
