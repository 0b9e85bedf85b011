// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/confidence.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

ConfidenceOptions plainOptions() {
  ConfidenceOptions options;
  options.confidence_inlier_distance = 0.2;
  options.confidence_low_inliers = 0.4;
  options.confidence_high_inliers = 0.8;
  options.confidence_rate = 0.5;
  options.converged_std = 0.5;
  options.ambiguous_mass = 0.2;
  return options;
}

Estimate estimateAt(const Pose2& pose, double deviation, double second_mass = 0.0) {
  Mode first;
  first.T_map_base = pose;
  first.covariance(0, 0) = deviation * deviation;
  first.mass = 1.0 - second_mass;
  Estimate estimate{pose, first.covariance, {first}};
  if (second_mass > 0.0) estimate.modes.push_back({{1.0, 2.0, 3.0}, first.covariance, second_mass});
  return estimate;
}

class ConfidenceTest : public testing::Test {
 protected:
  ConfidenceTest()
      : confidence_(plainOptions(), std::make_shared<const DistanceField>(*asymmetricWorld())) {}

  Observations seen_ = ToyLaser{}.observe(asymmetricWorld(), {1.0, 1.0, 0.0});
  Confidence confidence_;
};

TEST_F(ConfidenceTest, IsFullWhereTheScanFitsAndTheBeliefIsOnePlace) {
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.0), seen_);
  EXPECT_DOUBLE_EQ(confidence_.fit(), 1.0);
  EXPECT_DOUBLE_EQ(confidence_.value(), 1.0);
  EXPECT_TRUE(confidence_.isCompact());
  EXPECT_FALSE(confidence_.isAmbiguous());
}

TEST_F(ConfidenceTest, FallsWithWidthAndWithMassElsewhere) {
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.5), seen_);
  EXPECT_NEAR(confidence_.value(), 0.5, 1e-12);
  EXPECT_FALSE(confidence_.isCompact());
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.0, 0.3), seen_);
  EXPECT_NEAR(confidence_.value(), 0.7, 1e-12);
  EXPECT_TRUE(confidence_.isAmbiguous());
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.0, 0.1), seen_);
  EXPECT_FALSE(confidence_.isAmbiguous());
}

TEST_F(ConfidenceTest, StretchesTheShareOfHitsThatFit) {
  // two of three hits on the wall that begins at x = 9.5, the third two metres before it
  const Observations seen = hitsAt({{9.52, 1.0}, {9.52, 0.8}, {7.5, 1.0}}, 20.0);
  confidence_.observe(estimateAt({}, 0.0), seen);
  EXPECT_NEAR(confidence_.fit(), (2.0 / 3.0 - 0.4) / 0.4, 1e-6);
}

TEST_F(ConfidenceTest, IsARunningMeanOfTheFit) {
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.0), seen_);
  confidence_.observe(estimateAt({-100.0, 0.0, 0.0}, 0.0), seen_);
  EXPECT_NEAR(confidence_.fit(), 0.5, 1e-12);
  confidence_.observe(estimateAt({-100.0, 0.0, 0.0}, 0.0), seen_);
  EXPECT_NEAR(confidence_.fit(), 0.25, 1e-12);
}

TEST_F(ConfidenceTest, LearnsNothingFromABlindScan) {
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.0), Observations{});
  EXPECT_EQ(confidence_.value(), 0.0);
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.0), seen_);
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.0), Observations{});
  EXPECT_EQ(confidence_.fit(), 1.0);
}

TEST_F(ConfidenceTest, ForgetsAllOnReset) {
  confidence_.observe(estimateAt({1.0, 1.0, 0.0}, 0.0, 0.3), seen_);
  confidence_.reset();
  EXPECT_EQ(confidence_.fit(), 0.0);
  EXPECT_EQ(confidence_.value(), 0.0);
  EXPECT_FALSE(confidence_.isCompact());
  EXPECT_FALSE(confidence_.isAmbiguous());
}

TEST(ConfidenceLimits, RefuseALowLimitAboveTheHighOne) {
  ConfidenceOptions options = plainOptions();
  options.confidence_low_inliers = 0.9;
  try {
    Confidence(options, nullptr);
    FAIL() << "took limits the wrong way round";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("confidence_low_inliers"));
  }
}

}  // namespace
}  // namespace adaptive_localization
