// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/told_pose.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {

TEST(ToldPose, IsCheckedAtOnceAndThenEverFartherApart) {
  ToldPose told(true);
  EXPECT_TRUE(told.isUnverified());
  double before = 0.0, way = 0.0;
  int checks = 0;
  for (int step = 0; step < 1000; ++step) {
    if (told.isCheckDue()) {
      told.checked();
      EXPECT_GE(way, before);
      before = way;
      way = 0.0;
      ++checks;
    }
    told.travel(0.1);
    way += 0.1;
  }
  EXPECT_FALSE(told.isUnverified());
  EXPECT_GE(checks, 5);
  EXPECT_LE(checks, 12);  // and at last no more
  EXPECT_FALSE(told.isCheckDue());
}

TEST(ToldPose, IsFreshUntilTheRobotHasDrivenOn) {
  ToldPose told(true);
  told.travel(0.25);
  EXPECT_TRUE(told.isFresh());
  told.travel(0.1);
  EXPECT_FALSE(told.isFresh());
}

TEST(ToldPose, OfNobodyIsNeverChecked) {
  ToldPose nobody(false);
  nobody.travel(100.0);
  EXPECT_FALSE(nobody.isUnverified());
  EXPECT_FALSE(nobody.isCheckDue());
}

}  // namespace adaptive_localization
