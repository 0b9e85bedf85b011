// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/doubt.hpp"

#include <gtest/gtest.h>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kPlace{2.0, 3.0, -0.5};
const TrackingOdds kOdds(true);

class DoubtTest : public testing::Test {
 protected:
  Scan seenFrom(const Pose2& pose) const {
    return ToyLaser{181, -kPi / 2, kPi / 2, 12.0}.observe(map_, pose).scan;
  }
  /// Drives on by so much, with a scan that fits the core's place or not.
  void drive(const Pose2& motion, bool fits) {
    doubt_.ride(motion);
    doubt_.count(fits);
  }

  std::shared_ptr<const OccupancyGrid> map_{asymmetricWorld()};
  Doubt doubt_{Ground(map_, std::make_shared<const DistanceField>(*map_)), noSenses()};
};

TEST_F(DoubtTest, MovesWithTheOdometryUntilItEnds) {
  EXPECT_FALSE(doubt_.isRaised());
  doubt_.raise(kPlace, kOdds);
  ASSERT_TRUE(doubt_.isRaised());
  doubt_.ride({0.3, 0.0, 0.1});
  const Pose2 expected = kPlace * Pose2{0.3, 0.0, 0.1};
  EXPECT_DOUBLE_EQ(doubt_.byOdometry().x, expected.x);
  EXPECT_DOUBLE_EQ(doubt_.byOdometry().y, expected.y);
  EXPECT_DOUBLE_EQ(doubt_.byOdometry().theta, expected.theta);
  doubt_.end();
  EXPECT_FALSE(doubt_.isRaised());
}

TEST_F(DoubtTest, ScansShowThePlaceWhereOdometryIsWrong) {
  const Pose2 wrong = kPlace * Pose2{0.15, -0.1, 0.05};
  doubt_.raise(wrong, kOdds);
  doubt_.follow(wrong, seenFrom(kPlace), 0.05);
  EXPECT_NEAR(doubt_.byScans().x, kPlace.x, 0.03);
  EXPECT_NEAR(doubt_.byScans().y, kPlace.y, 0.03);
  EXPECT_NEAR(doubt_.byScans().theta, kPlace.theta, 0.02);
  EXPECT_EQ(doubt_.byOdometry().x, wrong.x);
}

/// As long as it is followed: scans have shown where it is since then.
TEST_F(DoubtTest, ADoubtThatIsRaisedAgainIsOfThePlaceThatIsFollowed) {
  doubt_.raise(kPlace, kOdds);
  doubt_.end();
  doubt_.raise({5.0, 1.0, 0.0}, kOdds);
  EXPECT_NEAR(doubt_.byOdometry().x, kPlace.x, 1e-9);
  doubt_.end();
  doubt_.keep({4.0, 2.0, 0.0}, kOdds);
  doubt_.raise(kPlace, kOdds);
  EXPECT_NEAR(doubt_.byOdometry().x, 4.0, 1e-9);
  doubt_.end();
  doubt_.forget();
  doubt_.raise(kPlace, kOdds);
  EXPECT_NEAR(doubt_.byOdometry().x, kPlace.x, 1e-9);
}

TEST_F(DoubtTest, CountsScansFromTheOneThatRaisesIt) {
  doubt_.count(true);
  doubt_.count(false);
  doubt_.raise(kPlace, kOdds);
  EXPECT_EQ(doubt_.scans(), 0);
  EXPECT_EQ(doubt_.misfits(), 1);
  EXPECT_DOUBLE_EQ(doubt_.shareOfMisfits(), 1.0);
  doubt_.count(true);
  doubt_.count(false);
  doubt_.count(true);
  EXPECT_EQ(doubt_.scans(), 3);
  EXPECT_EQ(doubt_.misfits(), 2);
  EXPECT_DOUBLE_EQ(doubt_.shareOfMisfits(), 0.5);
  doubt_.end();
  doubt_.count(true);
  EXPECT_EQ(doubt_.scans(), 0);
  EXPECT_EQ(doubt_.misfits(), 0);
}

TEST_F(DoubtTest, IsBriefForSomeScansAndHalfAMetre) {
  doubt_.raise(kPlace, kOdds);
  for (int i = 0; i < 9; ++i) drive({}, false);
  EXPECT_TRUE(doubt_.isBrief());
  drive({}, false);
  EXPECT_FALSE(doubt_.isBrief()) << "ten scans";
  doubt_.end();
  doubt_.count(true);
  doubt_.raise(kPlace, kOdds);
  drive({0.3, 0.0, 0.1}, false);
  EXPECT_TRUE(doubt_.isBrief());
  drive({0.15, 0.0, 0.0}, false);
  EXPECT_FALSE(doubt_.isBrief()) << "a way of 0.55";
}

TEST_F(DoubtTest, ACoreThatMovesByMoreThanOdometryCanBeOffHasSlid) {
  doubt_.count(false);
  doubt_.raise(kPlace, kOdds);
  const auto beside = [&](double by) { return doubt_.byOdometry() * Pose2{0.0, by, 0.0}; };
  EXPECT_FALSE(doubt_.hasSlid(beside(1.0))) << "one scan alone did not fit";
  drive({0.1, 0.0, 0.0}, false);
  EXPECT_FALSE(doubt_.hasSlid(beside(0.25)));
  EXPECT_TRUE(doubt_.hasSlid(beside(0.35)));
  EXPECT_TRUE(doubt_.hasSlid(doubt_.byOdometry() * Pose2{0.0, 0.0, 0.3})) << "turned";
  drive({4.0, 0.0, 0.0}, false);
  EXPECT_FALSE(doubt_.hasSlid(beside(0.55))) << "0.15 of the way";
  EXPECT_TRUE(doubt_.hasSlid(beside(0.65)));
  doubt_.end();
  EXPECT_FALSE(doubt_.hasSlid(kPlace * Pose2{9.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace adaptive_localization
