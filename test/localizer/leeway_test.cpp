// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/leeway.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

const Pose2 kPlace{1.0, 2.0, 0.0};

Estimate estimateOf(const Pose2& pose, double deviation) {
  Estimate estimate;
  estimate.T_map_base = pose;
  estimate.covariance = deviation * deviation * Eigen::Matrix3d::Identity();
  return estimate;
}

TEST(Leeway, OfNoPlaceAllowsNone) {
  Leeway leeway;
  leeway.ride({1.0, 0.0, 0.0});
  EXPECT_FALSE(leeway.isAt({1.0, 0.0, 0.0}));
  EXPECT_FALSE(leeway.allows({1.0, 0.0, 0.0}));
  leeway.note(estimateOf(kPlace, 0.1), true);
  EXPECT_TRUE(leeway.isAt(kPlace));
  leeway.end();
  EXPECT_FALSE(leeway.isAt(kPlace));
}

TEST(Leeway, IsWhatTheCoreDidNotKnowOfThePlace) {
  const Pose2 off = kPlace * Pose2{1.2, 0.0, 0.0};
  Leeway leeway;
  leeway.note(estimateOf(kPlace, 0.1), true);
  EXPECT_FALSE(leeway.allows(off));
  leeway.note(estimateOf(kPlace, 0.5), false);
  EXPECT_TRUE(leeway.allows(off));
  EXPECT_FALSE(leeway.isAt(off));
}

TEST(Leeway, ShrinksOnlyWhereThePlaceIsKnown) {
  const Pose2 off = kPlace * Pose2{1.2, 0.0, 0.0};
  Leeway leeway;
  leeway.note(estimateOf(kPlace, 0.5), true);
  leeway.note(estimateOf(kPlace, 0.1), false);
  EXPECT_TRUE(leeway.allows(off)) << "it is one of several";
  leeway.note(estimateOf(kPlace, 0.1), true);
  EXPECT_FALSE(leeway.allows(off));
}

TEST(Leeway, RidesOnOdometryWhereTheCoreIsElsewhere) {
  Leeway leeway;
  leeway.note(estimateOf(kPlace, 0.5), true);
  leeway.note(estimateOf(kPlace * Pose2{1.2, 0.0, 0.0}, 0.1), true);
  EXPECT_TRUE(leeway.isAt(kPlace));
  leeway.ride({0.0, 0.0, 1.0});
  leeway.ride({2.0, 0.0, 0.0});
  EXPECT_TRUE(leeway.isAt(kPlace * Pose2{0.0, 0.0, 1.0} * Pose2{2.0, 0.0, 0.0}));
  leeway.moveTo(kPlace);
  EXPECT_TRUE(leeway.isAt(kPlace));
  EXPECT_TRUE(leeway.allows(kPlace * Pose2{1.2, 0.0, 0.0})) << "it may be anywhere still";
}

}  // namespace
}  // namespace adaptive_localization
