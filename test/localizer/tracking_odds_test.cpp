// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/tracking_odds.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {

TEST(TrackingOdds, GrowByTheWayAndSaturate) {
  TrackingOdds odds(false);
  double before = odds.value();
  for (int i = 0; i < 10; ++i) {
    odds.earn({0.1, 0.0, 0.3});
    EXPECT_NEAR(odds.value() - before, 0.3, 1e-9);
    before = odds.value();
  }
  for (int i = 0; i < 1000; ++i) odds.earn({0.1, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(odds.value(), 18.0);
  odds.earn({0.0, 0.0, 1.0});  // a turn is no way
  EXPECT_DOUBLE_EQ(odds.value(), 18.0);
}

TEST(TrackingOdds, AnInitialPoseIsWorthMoreThanAPlaceJustFound) {
  EXPECT_GT(TrackingOdds(true).value(), TrackingOdds(false).value());
}

TEST(TrackingOdds, AreSomebodysWordUntilScansTell) {
  TrackingOdds odds(true);
  EXPECT_DOUBLE_EQ(odds.word(), odds.value());
  odds.seeNothing();
  EXPECT_DOUBLE_EQ(odds.word(), odds.value());  // never more than all
  odds.find();
  EXPECT_EQ(odds.word(), 0.0);
  EXPECT_EQ(TrackingOdds(false).word(), 0.0);
}

TEST(TrackingOdds, KeepAPlaceOnceTheyAreNearlyWhatAWordIsWorth) {
  TrackingOdds odds(false);
  EXPECT_FALSE(odds.isKept());
  odds.earn({2.1, 0.0, 0.0});
  EXPECT_TRUE(odds.isKept());
  TrackingOdds word(true);
  EXPECT_TRUE(word.isKept());
  word.seeNothing();
  EXPECT_TRUE(word.isKept()) << "a scan that sees nothing is no reason to leave";
  TrackingOdds carried(true);
  for (int i = 0; i < 100; ++i) carried.earn({0.1, 0.0, 0.0});
  carried.beCarried();
  EXPECT_FALSE(carried.isKept()) << "however much was known";
}

TEST(TrackingOdds, AreLostByWhatCannotBeSeen) {
  TrackingOdds odds(true);
  for (int i = 0; i < 30; ++i) odds.seeNothing();
  EXPECT_LT(odds.value(), 0.5);
  odds.find();
  EXPECT_DOUBLE_EQ(odds.value(), TrackingOdds(false).value());
  odds.checkJump({1.0, 0.0, 0.0});
  EXPECT_GT(odds.value(), 0.0);
  odds.checkJump({0.0, -5.0, 0.0});
  EXPECT_EQ(odds.value(), 0.0);
}

TEST(TrackingOdds, AreLostByTheWayOnWhichNothingFits) {
  TrackingOdds odds(true), standing(true), by_steps(true), once(true);
  for (int i = 0; i < 10; ++i) standing.seeNothing({});
  for (int i = 0; i < 4; ++i) by_steps.seeNothing({0.015, 0.02, 0.0});
  once.seeNothing({0.0, 0.0, -0.1});
  odds.seeNothing();
  for (const TrackingOdds& other : {standing, by_steps, once}) {
    EXPECT_NEAR(other.value(), odds.value(), 1e-9);
  }
  once.seeNothing({2.0, 0.0, 0.0});
  odds.seeNothing();
  EXPECT_NEAR(once.value(), odds.value(), 1e-9) << "no more than by a scan";
}

TEST(TrackingOdds, AreLostToScansAndByBeingCarriedDownToWhatASearchWouldTell) {
  TrackingOdds odds(true);
  odds.lose(4.0);
  EXPECT_DOUBLE_EQ(odds.value(), TrackingOdds(true).value() - 4.0);
  EXPECT_FALSE(odds.isKept());
  odds.lose(40.0);
  EXPECT_DOUBLE_EQ(odds.value(), TrackingOdds(false).value());

  TrackingOdds carried(true);
  carried.beCarried();
  EXPECT_DOUBLE_EQ(carried.value(), TrackingOdds(false).value());
  EXPECT_EQ(carried.word(), 0.0);
  for (int i = 0; i < 30; ++i) carried.seeNothing();
  const double less = carried.value();
  carried.beCarried();
  EXPECT_DOUBLE_EQ(carried.value(), less);
}

TEST(TrackingOdds, AreSpentByTheWayOfALostRobot) {
  TrackingOdds odds(true);
  EXPECT_FALSE(odds.areSpent());
  odds.loseWay({1.0, 0.0, 2.0});  // a turn is no way
  EXPECT_DOUBLE_EQ(odds.value(), TrackingOdds(true).value() - 1.0);
  odds.loseWay({1.0, 0.0, 0.0}, true);  // scans hardly fit
  EXPECT_DOUBLE_EQ(odds.value(), TrackingOdds(true).value() - 3.0);
  for (int i = 0; i < 10; ++i) odds.loseWay({1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(odds.value(), TrackingOdds(false).value());  // what a search would tell
  EXPECT_TRUE(odds.areSpent());
  for (int i = 0; i < 30; ++i) odds.seeNothing();
  const double less = odds.value();
  odds.loseWay({1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(odds.value(), less);
}

TEST(TrackingOdds, RuleOutPlacesThatLookAlikeByWhatIsEarnedAndByTheirNumber) {
  TrackingOdds odds(true);
  EXPECT_TRUE(odds.ruleOut(0));
  EXPECT_FALSE(odds.ruleOut(1));
  for (int i = 0; i < 100; ++i) odds.earn({0.1, 0.0, 0.0});
  EXPECT_TRUE(odds.ruleOut(1));
  EXPECT_TRUE(odds.ruleOut(20));
  EXPECT_FALSE(odds.ruleOut(21));
}

TEST(TrackingOdds, AreLostByScansThatSeeNothingUntilAPlaceIsFound) {
  TrackingOdds odds(true);
  for (int i = 0; i < 10; ++i) odds.seeNothing();  // a second
  EXPECT_FALSE(odds.areLost());
  for (int i = 0; i < 10; ++i) odds.loseWay({1.0, 0.0, 0.0});
  EXPECT_FALSE(odds.areLost()) << "spent, as if a search had told the place";
  odds.seeNothing();
  EXPECT_TRUE(odds.areLost());
  odds.find();
  EXPECT_FALSE(odds.areLost());
}

}  // namespace adaptive_localization
