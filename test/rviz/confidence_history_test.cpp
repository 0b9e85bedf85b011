// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/confidence_history.hpp"

#include <gmock/gmock.h>

namespace adaptive_localization {

TEST(ConfidenceHistory, KeepsTwoMinutes) {
  ConfidenceHistory history;
  for (int i = 0; i <= 200; ++i) history.add({1000.0 + i, 0.5, "tracking"});
  EXPECT_EQ(history.samples().front().stamp, 1080.0);
  EXPECT_EQ(history.samples().back().stamp, 1200.0);
  EXPECT_EQ(history.samples().size(), 121U);
  EXPECT_EQ(history.secondsInStatus(), 200.0) << "longer than the plot";
}

TEST(ConfidenceHistory, OfAQuarterOfASecondTheLeastIsKept) {
  ConfidenceHistory history;
  history.add({1.0, 0.9, "tracking"});
  history.add({1.1, 0.2, "tracking"});
  history.add({1.2, 0.8, "tracking"});
  ASSERT_EQ(history.samples().size(), 1U);
  EXPECT_EQ(history.samples().back().confidence, 0.2);
  history.add({1.25, 0.7, "tracking"});
  EXPECT_EQ(history.samples().size(), 2U);
}

TEST(ConfidenceHistory, EachChangeOfTheStatusIsKept) {
  ConfidenceHistory history;
  history.add({1.0, 0.9, "tracking"});
  history.add({1.1, 0.1, "lost"});
  ASSERT_EQ(history.samples().size(), 2U);
  EXPECT_EQ(history.samples().front().confidence, 0.9);
  EXPECT_EQ(history.samples().back().status, "lost");
  EXPECT_EQ(history.secondsInStatus(), 0.0);
  history.add({3.1, 0.1, "lost"});
  EXPECT_EQ(history.secondsInStatus(), 2.0);
}

TEST(ConfidenceHistory, IsClearedWhenTimeJumpsBack) {
  ConfidenceHistory history;
  history.add({100.0, 0.9, "tracking"});
  history.add({105.0, 0.9, "tracking"});
  history.add({104.9, 0.1, "tracking"});
  EXPECT_EQ(history.samples().size(), 2U) << "another laser";
  history.add({3.0, 0.4, "tracking"});
  ASSERT_EQ(history.samples().size(), 1U);
  EXPECT_EQ(history.samples().front().stamp, 3.0);
  EXPECT_EQ(history.secondsInStatus(), 0.0);
}

TEST(ConfidenceHistory, ThereIsNoneAtFirst) {
  EXPECT_EQ(ConfidenceHistory().secondsInStatus(), 0.0);
  EXPECT_TRUE(ConfidenceHistory().samples().empty());
}

}  // namespace adaptive_localization
