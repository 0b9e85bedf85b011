// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/search_pace.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace adaptive_localization {

TEST(SearchPace, SlowsDownWhileNothingComesOfIt) {
  SearchPace pace;
  pace.begin();
  std::vector<int> pauses;
  for (int scan = 0, last = 0; scan < 40; ++scan) {
    if (!pace.isDue(false)) continue;
    pace.searched(false, 0.5);
    pauses.push_back(scan - last);
    last = scan;
  }
  EXPECT_THAT(pauses, testing::ElementsAre(0, 2, 4, 8, 9, 9));
  pace.searched(true, 0.02);
  EXPECT_TRUE(pace.isDue(false));
}

TEST(SearchPace, APauseEndsEarlyWhereAScanFitsFarWorse) {
  SearchPace pace;
  pace.begin();
  pace.searched(false, 0.3);
  pace.findNothingBetter(0.2);
  EXPECT_FALSE(pace.isOver(0.2));
  EXPECT_FALSE(pace.isOver(0.29));
  EXPECT_TRUE(pace.isOver(0.31));
  pace.skipScan();
  EXPECT_TRUE(pace.isOver(0.2));
}

TEST(SearchPace, GoesByTheWayWhilePlacesAreLeft) {
  SearchPace pace;
  pace.begin();
  EXPECT_FALSE(pace.isDue(true));
  pace.travel(0.6);
  EXPECT_FALSE(pace.isDue(true));
  pace.travel(0.6);
  EXPECT_TRUE(pace.isDue(true));
  pace.searched(true, 0.02);
  EXPECT_FALSE(pace.isDue(true));
}

TEST(SearchPace, KnowsThatAScanWhichFittedNowhereFoundNotAll) {
  SearchPace pace;
  pace.begin();
  pace.searched(false, 0.3);
  pace.searched(true, 0.14);
  EXPECT_FALSE(pace.wasBlind(0.1));
  EXPECT_TRUE(pace.wasBlind(0.05));
  pace.searched(true, 0.06);  // searched again
  EXPECT_FALSE(pace.wasBlind(0.01));
  pace.miss(0.3);
  EXPECT_FALSE(pace.wasBlind(0.16));
  EXPECT_TRUE(pace.wasBlind(0.05));
  pace.searched(true, 0.06);
  EXPECT_FALSE(pace.wasBlind(0.05));
  pace.begin();
  EXPECT_TRUE(pace.wasBlind(0.05));
}

TEST(SearchPace, IsUnsureUntilAScanThatFitsAsUsualWasSearchedForOrSomeOthers) {
  constexpr double kUsual = 0.08;
  SearchPace pace;
  pace.begin();
  EXPECT_TRUE(pace.isUnsure(kUsual));
  pace.searched(true, 0.09);
  EXPECT_TRUE(pace.isUnsure(kUsual));
  pace.searched(true, 0.07);
  EXPECT_FALSE(pace.isUnsure(kUsual));
  EXPECT_TRUE(pace.isUnsure(0.0)) << "as of one of many";
  pace.begin();
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(pace.isUnsure(kUsual)) << i;
    pace.searched(true, 0.09);
  }
  EXPECT_FALSE(pace.isUnsure(kUsual));
}

TEST(SearchPace, SeesElseHalfAMetreAfterASearch) {
  SearchPace pace;
  pace.begin();
  pace.travel(0.6);
  EXPECT_TRUE(pace.seesElse());
  pace.searched(true, 0.09);
  EXPECT_FALSE(pace.seesElse());
  pace.travel(0.4);
  EXPECT_FALSE(pace.seesElse());
  pace.travel(0.2);
  EXPECT_TRUE(pace.seesElse());
}

TEST(SearchPace, InsistsOnASearchUntilItIsDone) {
  SearchPace pace;
  pace.begin();
  pace.searched(true, 0.14);
  EXPECT_FALSE(pace.wasBlind(0.1));
  pace.insist();
  EXPECT_TRUE(pace.wasBlind(0.1)) << "whatever scan comes";
  pace.searched(true, 0.14);
  EXPECT_FALSE(pace.wasBlind(0.1));
  pace.insist();
  pace.begin();
  EXPECT_FALSE(pace.wasBlind(0.3));
}

TEST(SearchPace, IsToldMoreByAScanThatFitsFarBetterAndOnceOnly) {
  SearchPace pace;
  pace.searched(false, 0.45);
  pace.searched(false, 0.45);
  pace.findNothingBetter(0.45);
  EXPECT_FALSE(pace.isOver(0.2));
  EXPECT_FALSE(pace.tellsMore(0.23));
  EXPECT_TRUE(pace.tellsMore(0.2));
  EXPECT_FALSE(pace.tellsMore(0.2)) << "that was searched for";
  EXPECT_TRUE(pace.tellsMore(0.09));
}

}  // namespace adaptive_localization
