// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/scan_change.hpp"

#include <gtest/gtest.h>

#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kHere{2.0, 3.0, -0.5};
const Pose2 kThere{6.5, 2.5, 3.0};

Scan seenFrom(const Pose2& pose) {
  return ToyLaser{181, -kPi / 2, kPi / 2, 12.0}.observe(asymmetricWorld(), pose).scan;
}

/// Beams from one number on, so many of them, see something at a share of their ranges.
Scan with(Scan scan, Eigen::Index first, Eigen::Index count, float share) {
  scan.range.segment(first, count) *= share;
  return scan;
}

TEST(ScanChange, ARobotThatIsPutDownElsewhereSeesAnotherPlace) {
  ScanChange change;
  EXPECT_FALSE(change.isElsewhere({}, seenFrom(kHere))) << "the first";
  EXPECT_FALSE(change.isElsewhere({}, seenFrom(kHere)));
  EXPECT_TRUE(change.isElsewhere({}, seenFrom(kThere))) << "at rest";
  EXPECT_FALSE(change.isElsewhere({}, seenFrom(kThere))) << "once";
  EXPECT_TRUE(change.isElsewhere({0.2, 0.0, 0.1}, seenFrom(kHere))) << "while the wheels turn";
}

TEST(ScanChange, DrivingIsNone) {
  for (const int beams : {31, 181}) {
    ScanChange change;
    Pose2 T_odom_base;
    for (const ToyStep& step : toyDrive(asymmetricWorld(), 1, beams)) {
      T_odom_base = T_odom_base * step.motion;
      ASSERT_FALSE(change.isElsewhere(T_odom_base, step.observations.scan))
          << beams << " beams, at " << step.T_map_base.x << ", " << step.T_map_base.y;
    }
  }
}

TEST(ScanChange, TellsHowMuchOfAScanChanged) {
  ScanChange change;
  change.isElsewhere({}, seenFrom(kHere));
  EXPECT_EQ(change.changedShare(), 1.0) << "nothing to compare it with";
  change.isElsewhere({0.1, 0.0, 0.0}, seenFrom(kHere * Pose2{0.1, 0.0, 0.0}));
  EXPECT_LT(change.changedShare(), 0.05);
  change.isElsewhere({0.1, 0.0, 0.0}, with(seenFrom(kHere * Pose2{0.1, 0.0, 0.0}), 0, 91, 0.4F));
  EXPECT_NEAR(change.changedShare(), 0.5, 0.05);
  EXPECT_NEAR(change.nearerShare(), 0.5, 0.05);
  change.isElsewhere({0.1, 0.0, 0.0}, seenFrom(kHere * Pose2{0.1, 0.0, 0.0}));
  EXPECT_NEAR(change.changedShare(), 0.5, 0.05);
  EXPECT_EQ(change.nearerShare(), 0.0) << "that is gone";
  change.isElsewhere({2.1, 0.0, 0.0}, seenFrom(kHere));
  EXPECT_EQ(change.changedShare(), 1.0) << "too far off";
  EXPECT_EQ(change.nearerShare(), 0.0);
}

/// Even if most ranges change by it.
TEST(ScanChange, WheelsThatSlipInATurnAreNone) {
  ScanChange change;
  change.isElsewhere({}, seenFrom(kHere));
  EXPECT_FALSE(change.isElsewhere({}, seenFrom(kHere * Pose2{0.0, 0.0, 0.2})));
  EXPECT_FALSE(change.isElsewhere({}, seenFrom(kHere * Pose2{0.05, 0.0, 0.0})));
}

TEST(ScanChange, PeopleAreNone) {
  ScanChange change;
  change.isElsewhere({}, seenFrom(kHere));
  EXPECT_FALSE(change.isElsewhere({}, with(seenFrom(kHere), 10, 110, 0.4F))) << "come";
  EXPECT_FALSE(change.isElsewhere({}, with(seenFrom(kHere), 15, 110, 0.4F))) << "walk by";
  EXPECT_FALSE(change.isElsewhere({}, seenFrom(kHere))) << "leave";
}

/// It sees none; what it sees thereafter is compared with what it saw before.
TEST(ScanChange, ALaserThatIsCoveredSeesNoOtherPlace) {
  const Scan covered = with(seenFrom(kHere), 0, 181, 0.01F);
  ScanChange change;
  change.isElsewhere({}, seenFrom(kHere));
  EXPECT_FALSE(change.isElsewhere({}, covered));
  EXPECT_FALSE(change.isElsewhere({}, seenFrom(kHere)));
  EXPECT_FALSE(change.isElsewhere({}, covered));
  EXPECT_TRUE(change.isElsewhere({}, seenFrom(kThere)));
}

TEST(ScanChange, AfterAWayNothingIsCompared) {
  for (const Pose2& motion : {Pose2{0.6, 0.0, 0.0}, Pose2{0.0, 0.0, 0.6}}) {
    ScanChange change;
    change.isElsewhere({}, seenFrom(kHere));
    EXPECT_FALSE(change.isElsewhere(motion, seenFrom(kThere)));
    EXPECT_TRUE(change.isElsewhere(motion, seenFrom(kHere))) << "but from then on";
  }
}

TEST(ScanChange, EachLaserIsComparedWithItself) {
  Scan left = seenFrom(kHere), right = seenFrom(kThere);
  left.position = {0.1, 0.2};
  right.position = {0.1, -0.2};
  ScanChange change;
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(change.isElsewhere({}, left));
    EXPECT_FALSE(change.isElsewhere({}, right));
  }
  left.range = seenFrom(kThere).range;
  EXPECT_TRUE(change.isElsewhere({}, left));
  EXPECT_FALSE(change.isElsewhere({}, right));
}

TEST(ScanChange, ForgetsWhatWasSeen) {
  ScanChange change;
  change.isElsewhere({}, seenFrom(kHere));
  change.forget();
  EXPECT_FALSE(change.isElsewhere({}, seenFrom(kThere)));
}

}  // namespace
}  // namespace adaptive_localization
