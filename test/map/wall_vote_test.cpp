// SPDX-License-Identifier: BSD-3-Clause
#include "map/wall_vote.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

WallVote votesOf(double evidence, int scans) {
  WallVote vote;
  for (int i = 0; i < scans; ++i) vote.add(evidence);
  return vote;
}

TEST(WallVote, IsTheSumOfWhatScansTell) {
  EXPECT_EQ(WallVote{}.leadOfMiddles(), 0.0);
  EXPECT_DOUBLE_EQ(votesOf(0.25, 8).leadOfMiddles(), 2.0);
  EXPECT_DOUBLE_EQ(votesOf(-0.25, 8).leadOfMiddles(), -2.0);
}

TEST(WallVote, NoScanTellsMoreThanOne) {
  EXPECT_DOUBLE_EQ(votesOf(30.0, 1).leadOfMiddles(), 1.0);
  EXPECT_DOUBLE_EQ(votesOf(-30.0, 1).leadOfMiddles(), -1.0);
}

TEST(WallVote, ChangesItsMindWithinFortyScansHoweverLongItWasSure) {
  WallVote vote = votesOf(1.0, 100000);
  EXPECT_GT(vote.leadOfMiddles(), 10.0);
  for (int i = 0; i < 40; ++i) vote.add(-1.0);
  EXPECT_LT(vote.leadOfMiddles(), 0.0);
}

}  // namespace
}  // namespace adaptive_localization
