// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/novelty.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

constexpr double kAllAround = 2.0 * kPi, kCamera = 1.0;  // views, rad

TEST(Novelty, TheFirstScanCountsInFull) {
  Novelty novelty;
  novelty.restart();
  EXPECT_DOUBLE_EQ(novelty.news(kAllAround).share, 1.0);
  EXPECT_DOUBLE_EQ(novelty.news(kAllAround).sight, 1.0);
}

TEST(Novelty, NothingIsNewWhileTheRobotStands) {
  Novelty novelty;
  novelty.restart();
  novelty.count();
  novelty.ride({});
  EXPECT_DOUBLE_EQ(novelty.news(kAllAround).share, 0.0);
  EXPECT_DOUBLE_EQ(novelty.news(kAllAround).sight, 0.0);
}

TEST(Novelty, ThreeStepsMakeANewScanAndAMetreShowsOtherThings) {
  Novelty novelty;
  novelty.ride({0.06, 0.08, 0.0});
  EXPECT_NEAR(novelty.news(kAllAround).share, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(novelty.news(kAllAround).sight, 0.1, 1e-12);
  novelty.ride({0.2, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(novelty.news(kAllAround).share, 1.0);
  EXPECT_NEAR(novelty.news(kAllAround).sight, 0.3, 1e-12);
  novelty.ride({1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(novelty.news(kAllAround).share, 1.0);
  EXPECT_DOUBLE_EQ(novelty.news(kAllAround).sight, 1.0);
}

TEST(Novelty, ATurnShowsWhatComesIntoView) {
  Novelty novelty;
  novelty.ride({0.0, 0.0, 0.2});
  novelty.ride({0.0, 0.0, -0.1});
  EXPECT_DOUBLE_EQ(novelty.news(kAllAround).share, 1.0);
  EXPECT_NEAR(novelty.news(kAllAround).sight, 0.3 / kAllAround, 1e-12);
  EXPECT_NEAR(novelty.news(kCamera).sight, 0.3, 1e-12);
  EXPECT_NEAR(novelty.news(0.1).sight, 1.0, 1e-12);  // never more than of the scan
}

}  // namespace
}  // namespace adaptive_localization
