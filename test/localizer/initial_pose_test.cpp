// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/initial_pose.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {

TEST(InitialPose, IsCheckedAtOnceAndThenEverFartherApart) {
  InitialPose given(true);
  EXPECT_TRUE(given.isUnverified());
  double before = 0.0, way = 0.0;
  int checks = 0;
  for (int step = 0; step < 1000; ++step) {
    if (given.isCheckDue()) {
      given.checked();
      EXPECT_GE(way, before);
      before = way;
      way = 0.0;
      ++checks;
    }
    given.travel(0.1);
    way += 0.1;
  }
  EXPECT_FALSE(given.isUnverified());
  EXPECT_GE(checks, 5);
  EXPECT_LE(checks, 12);  // and at last no more
  EXPECT_FALSE(given.isCheckDue());
}

TEST(InitialPose, IsFreshUntilTheRobotHasDrivenOn) {
  InitialPose given(true);
  given.travel(0.25);
  EXPECT_TRUE(given.isFresh());
  given.travel(0.1);
  EXPECT_FALSE(given.isFresh());
}

TEST(InitialPose, OfNobodyIsNeverChecked) {
  InitialPose nobody(false);
  nobody.travel(100.0);
  EXPECT_FALSE(nobody.isUnverified());
  EXPECT_FALSE(nobody.isCheckDue());
}

TEST(InitialPose, IsCheckedOnceMoreWhereThatIsAskedFor) {
  InitialPose nobody(false);
  nobody.checkNow();
  EXPECT_FALSE(nobody.isUnverified());
  EXPECT_TRUE(nobody.isCheckDue());
  nobody.checked();
  nobody.travel(100.0);
  EXPECT_FALSE(nobody.isCheckDue());

  InitialPose given(true);
  given.checked();
  given.checkNow();
  EXPECT_TRUE(given.isCheckDue());
  given.checked();
  EXPECT_FALSE(given.isCheckDue());
  given.travel(2.0);
  EXPECT_TRUE(given.isCheckDue());  // as before
}

}  // namespace adaptive_localization
