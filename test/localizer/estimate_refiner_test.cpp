// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/localizer/estimate_refiner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/differential_drive.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

Estimate estimateAt(const Pose2& pose, double std = 0.03) {
  Estimate estimate;
  estimate.T_map_base = pose;
  estimate.covariance = std * std * Eigen::Matrix3d::Identity();
  estimate.modes = {{pose, estimate.covariance, 1.0}};
  return estimate;
}

Pose2 shifted(const Pose2& pose, double x, double y, double theta) {
  return {pose.x + x, pose.y + y, wrapAngle(pose.theta + theta)};
}

class Refining : public testing::Test {
 protected:
  std::shared_ptr<const OccupancyGrid> map_ = asymmetricWorld();
  std::vector<ToyStep> drive_ = toyDrive(map_, 5, 91);
  SurfaceMaps surfaces_{map_, MapQuality(*map_)};
  EstimateRefiner refiner_{matchBy(makeScanMatcher(MatchOptions{}, surfaces_)),
                           std::make_unique<DifferentialDrive>(MotionOptions{})};
  Rng rng_{8};
};

TEST_F(Refining, BringsNoisyEstimatesToTheTruth) {
  double before = 0.0, after = 0.0;
  for (const ToyStep& step : drive_) {
    const Pose2 noisy = shifted(step.T_map_base, rng_.normal(0.0, 0.03), rng_.normal(0.0, 0.03),
                                rng_.normal(0.0, 0.02));
    const Estimate refined = refiner_.refine(estimateAt(noisy), step.motion, step.observations);
    ASSERT_TRUE(refiner_.match());
    before += distance(noisy, step.T_map_base);
    after += distance(refined.T_map_base, step.T_map_base);
    EXPECT_EQ(refined.modes.front().T_map_base.x, refined.T_map_base.x);
    EXPECT_EQ(refined.modes.front().covariance, refined.covariance);
    EXPECT_LT(refined.covariance.trace(), estimateAt(noisy).covariance.trace());
  }
  EXPECT_LT(after, before / 5.0);
  EXPECT_LT(after / static_cast<double>(drive_.size()), 0.007);
}

TEST_F(Refining, KnowsMoreFromManyScansThanFromOne) {
  double first = 0.0, last = 0.0;
  for (int i = 0; i < 10; ++i) {
    const ToyStep& step = drive_.front();
    const Estimate refined = refiner_.refine(estimateAt(step.T_map_base), {}, step.observations);
    if (i == 0) first = refined.covariance.trace();
    last = refined.covariance.trace();
  }
  EXPECT_LT(last, first);
  refiner_.reset();
  const ToyStep& step = drive_.front();
  const Estimate anew = refiner_.refine(estimateAt(step.T_map_base), {}, step.observations);
  EXPECT_NEAR(anew.covariance.trace(), first, 1e-12);
}

TEST_F(Refining, BelievesInAWideCloudOnlyAMatchThatExplainsTheScan) {
  const ToyStep& step = drive_.front();
  const Estimate wide = estimateAt(shifted(step.T_map_base, 0.08, -0.05, 0.02), 0.2);
  const Estimate refined = refiner_.refine(wide, {}, step.observations);
  EXPECT_LT(distance(refined.T_map_base, step.T_map_base), 0.015);

  Observations half = step.observations;  // of its hits are on things that the map does not know
  for (Eigen::Index i = 0; i < half.scan.x.size(); i += 2) {
    const auto nearer = static_cast<float>(rng_.uniform());
    half.scan.x[i] *= nearer;
    half.scan.y[i] *= nearer;
  }
  refiner_.reset();
  const Estimate same = refiner_.refine(wide, {}, half);
  EXPECT_TRUE(refiner_.match());
  EXPECT_EQ(same.T_map_base.x, wide.T_map_base.x);
  EXPECT_EQ(same.covariance, wide.covariance);

  const Estimate narrow = estimateAt(wide.T_map_base, 0.1);
  EXPECT_LT(distance(refiner_.refine(narrow, {}, half).T_map_base, step.T_map_base), 0.03);
}

/// A scan a metre on, with obstacles: the cloud is wide, odometry is not.
TEST_F(Refining, BelievesInAWideCloudAMatchThatOdometryLetsExpect) {
  const ToyStep& step = drive_.front();
  Observations half = step.observations;
  for (Eigen::Index i = 0; i < half.scan.x.size(); i += 2) {
    const auto nearer = static_cast<float>(rng_.uniform());
    half.scan.x[i] *= nearer;
    half.scan.y[i] *= nearer;
  }
  refiner_.refine(estimateAt(step.T_map_base), {}, step.observations);
  const Estimate wide = estimateAt(shifted(step.T_map_base, 0.15, -0.1, 0.05), 0.2);
  const Estimate refined = refiner_.refine(wide, {}, half);
  EXPECT_LT(refiner_.match()->inlier_ratio, 0.7);
  EXPECT_LT(distance(refined.T_map_base, step.T_map_base), 0.03);
}

TEST_F(Refining, LeavesACloudAloneThatIsTooWide) {
  const Estimate wide = estimateAt(drive_.front().T_map_base, 0.5);
  const Estimate same = refiner_.refine(wide, {}, drive_.front().observations);
  EXPECT_EQ(same.T_map_base.x, wide.T_map_base.x);
  EXPECT_EQ(same.covariance, wide.covariance);
  EXPECT_FALSE(refiner_.match());
}

TEST_F(Refining, GoesWhereTheFilterGoes) {
  const ToyStep& here = drive_.front();
  const ToyStep& there = drive_[30];
  refiner_.refine(estimateAt(here.T_map_base), {}, here.observations);
  const Pose2 rough = shifted(there.T_map_base, 0.03, -0.02, 0.01);
  const Estimate refined = refiner_.refine(estimateAt(rough), {}, there.observations);
  EXPECT_TRUE(refiner_.match()->isGood());
  EXPECT_LT(distance(refined.T_map_base, there.T_map_base), 0.015);
}

TEST_F(Refining, DoesNotLeaveThePlaceThatAFilterIsSureOf) {
  const ToyStep& step = drive_.front();
  const Estimate off = estimateAt(shifted(step.T_map_base, 0.25, 0.0, 0.0), 0.01);
  const Estimate kept = refiner_.refine(off, {}, step.observations);
  EXPECT_EQ(refiner_.match()->fault, MatchFault::kJump);
  EXPECT_EQ(kept.T_map_base.x, off.T_map_base.x);
  EXPECT_EQ(kept.covariance, off.covariance);
}

TEST_F(Refining, LeavesAnEstimateAsItIsWhereTheScanIsOfNoUse) {
  Observations blind;
  const Estimate estimate = estimateAt(drive_.front().T_map_base);
  const Estimate same = refiner_.refine(estimate, {}, blind);
  EXPECT_EQ(refiner_.match()->fault, MatchFault::kFewHits);
  EXPECT_EQ(same.T_map_base.x, estimate.T_map_base.x);
}

}  // namespace
}  // namespace adaptive_localization
