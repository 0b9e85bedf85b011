// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/filters/ekf_icp.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "adaptive_localization/filters/builtins.hpp"
#include "match/scan_matcher.hpp"
#include "motion/differential_drive.hpp"
#include "support/pose_matchers.hpp"
#include "support/thick_room.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

std::unique_ptr<Filter> makeEkf() {
  return builtins().filters.make("ekf_icp", FilterContext{builtins(), asymmetricWorld()});
}

Gaussian2 roughly(const Pose2& mean) {
  return {mean, Eigen::Vector3d(0.01, 0.01, 0.005).asDiagonal()};
}

Observations seenAt(const Pose2& pose) {
  return ToyLaser{91}.observe(asymmetricWorld(), pose);
}

/// Beams that see somebody right before the robot.
Observations crowded(Observations seen, double share) {
  Rng rng(9);
  for (Eigen::Index i = 0; i < seen.scan.x.size(); ++i) {
    if (rng.uniform() >= share) continue;
    const float nearer = 0.3F;
    seen.scan.x[i] *= nearer;
    seen.scan.y[i] *= nearer;
    seen.scan.range[i] *= nearer;
  }
  return seen;
}

Observations crowdedAt(const Pose2& pose, double share) {
  return crowded(seenAt(pose), share);
}

const Pose2 kPlace{2.0, 3.0, -0.5};

TEST(EkfIcp, IsRightWithinACellThoughFourTenthsOfTheBeamsSeePeople) {
  const auto filter = makeEkf();
  filter->reset(roughly(kPlace * Pose2{0.08, -0.05, 0.04}));
  Estimate estimate;
  for (int k = 0; k < 5; ++k) estimate = filter->update({}, crowdedAt(kPlace, 0.4));
  EXPECT_THAT(estimate.T_map_base, PoseNear(kPlace, 0.05, 0.01));
  ASSERT_NE(filter->match(), nullptr);
  EXPECT_TRUE(filter->match()->isGood());
  EXPECT_NEAR(filter->match()->inlier_ratio, 0.6, 0.1);
}

TEST(EkfIcp, GoesOnByOdometryAndDoubtsWhileNothingFits) {
  const auto filter = makeEkf();
  filter->reset(roughly(kPlace));
  filter->update({}, seenAt(kPlace));
  double before = 0.0;
  Scan few = seenAt(kPlace).scan;
  for (auto* column : {&few.x, &few.y, &few.range, &few.bearing}) column->conservativeResize(9);
  Pose2 expected = filter->estimate().T_map_base;
  for (int k = 0; k < 20; ++k) {
    expected = expected * Pose2{0.05, 0.0, 0.02};
    const Estimate estimate = filter->update({0.05, 0.0, 0.02}, {0.0, few});
    EXPECT_EQ(filter->match()->fault, MatchFault::kFewHits);
    EXPECT_THAT(estimate.T_map_base, PoseNear(expected, 1e-9, 1e-9));
    ASSERT_GT(estimate.covariance.determinant(), before);
    before = estimate.covariance.determinant();
  }
}

TEST(EkfIcp, SaysThatPeopleAreAllItSees) {
  const auto filter = makeEkf();
  filter->reset(roughly(kPlace));
  const Estimate estimate = filter->update({}, crowdedAt(kPlace, 1.0));
  EXPECT_EQ(filter->match()->fault, MatchFault::kOutliers);
  EXPECT_THAT(estimate.T_map_base, PoseNear(kPlace, 1e-9, 1e-9));
}

/// Its error where it has gone about a room with walls 0.35 m thick, of which the laser sees what
/// is in their middles, m.
double errorBetweenThickWalls(bool weighs) {
  const auto map = roomWithWalls(0, 7), world = roomWithWalls(3, 4);
  FilterContext context{builtins(), map};
  context.parameters.set("ekf_weigh_cloud", OptionValue(weighs));
  const auto filter = builtins().filters.make("ekf_icp", context);
  Pose2 truth{1.5, 1.5, 0.3};
  filter->reset(roughly(truth * Pose2{0.1, 0.08, 0.0}));
  for (int k = 0; k < 40; ++k) {
    const Pose2 motion{k % 20 < 10 ? 0.1 : -0.1, 0.0, 0.1};
    truth = truth * motion;
    filter->update(motion, ToyLaser{181, -kPi / 2, kPi / 2, 12.0}.observe(world, truth));
  }
  EXPECT_EQ(filter->match()->fault, weighs ? MatchFault::kSlides : MatchFault::kNone);
  return distance(filter->estimate().T_map_base, truth);
}

TEST(EkfIcp, IsCorrectedByACloudWhereWallsAreThick) {
  EXPECT_LT(errorBetweenThickWalls(true), 0.03);
  EXPECT_GT(errorBetweenThickWalls(false), errorBetweenThickWalls(true));
}

TEST(EkfIcp, WeighsNoCloudByAScanThatIsRefused) {
  FilterContext context{builtins(), roomWithWalls(0, 7)};
  const auto filter = builtins().filters.make("ekf_icp", context);
  const Pose2 place{1.5, 1.5, 0.3}, motion{0.2, 0.0, 0.1};
  filter->reset(roughly(place));
  const auto seen = ToyLaser{181, -kPi / 2, kPi / 2, 12.0}.observe(roomWithWalls(3, 4), place);
  const Estimate estimate = filter->update(motion, crowded(seen, 1.0));
  EXPECT_EQ(filter->match()->fault, MatchFault::kOutliers);
  EXPECT_THAT(estimate.T_map_base, PoseNear(place * motion, 1e-9, 1e-9));
}

TEST(EkfIcp, DoesNotBelieveAMatchFarFromWhereOdometrySays) {
  const auto filter = makeEkf();
  const Pose2 beside = kPlace * Pose2{0.25, 0.0, 0.0};
  filter->reset(Gaussian2{beside, Eigen::Vector3d(0.0025, 0.0025, 0.0025).asDiagonal()});
  const Estimate estimate = filter->update({}, seenAt(kPlace));
  EXPECT_EQ(filter->match()->fault, MatchFault::kJump);
  EXPECT_THAT(estimate.T_map_base, PoseNear(beside, 1e-9, 1e-9));
}

/// A match that is good by chance, of a robot that may be anywhere, is not used: it must say so.
TEST(EkfIcp, SaysThatItDoesNotKnowFromWhereToMatch) {
  EkfParts parts;
  parts.motion = std::make_unique<DifferentialDrive>(MotionOptions{});
  parts.match = [](const Pose2& guess, const Scan&, const Eigen::Matrix3d&) {
    Match match;
    match.T_map_base = guess;
    match.H = Eigen::Matrix3d::Identity();
    match.variance = match.rest = Eigen::Vector3d::Constant(1e-4);
    match.inlier_ratio = 1.0;
    return match;
  };
  parts.elsewhere = std::make_unique<FreeSpaceSampler>(asymmetricWorld());  // never knows where
  EkfIcp filter({}, std::move(parts), 1);
  filter.reset(Anywhere{});
  const Estimate before = filter.estimate();
  const Estimate after = filter.update({}, seenAt(kPlace));
  EXPECT_EQ(filter.match()->fault, MatchFault::kNoGuess);
  EXPECT_THAT(after.T_map_base, PoseNear(before.T_map_base, 1e-9, 1e-9));
}

TEST(EkfIcp, FindsItselfAgainAfterOdometryJumpedByAMetre) {
  const auto filter = makeEkf();
  filter->reset(roughly(kPlace));
  filter->update({}, seenAt(kPlace));
  filter->update({1.0, 0.3, 0.0}, seenAt(kPlace));
  Estimate estimate = filter->estimate();
  for (int k = 0; k < 6; ++k) estimate = filter->update({}, seenAt(kPlace));
  EXPECT_THAT(estimate.T_map_base, PoseNear(kPlace, 0.05, 0.02));
}

/// A place before that looks like this one: in 0.1 s nobody drives a metre, in 2 s robots do.
TEST(EkfIcp, UndoesAMetreOnlyIfItWasTooFast) {
  for (const double seconds : {0.1, 2.0}) {
    const auto filter = makeEkf();
    filter->reset(roughly(kPlace));
    filter->update({}, seenAt(kPlace));
    Observations seen = seenAt(kPlace);
    seen.stamp = seconds;
    const Estimate estimate = filter->update({1.0, 0.3, 0.0}, seen);
    const bool is_undone = distance(estimate.T_map_base, kPlace) < 0.1;
    EXPECT_EQ(is_undone, seconds < 1.0) << seconds << " s";
  }
}

TEST(EkfIcp, FindsItselfAnywhereByOneScan) {
  const auto filter = makeEkf();
  filter->reset(Anywhere{});
  EXPECT_THAT(filter->update({}, seenAt(kPlace)).T_map_base, PoseNear(kPlace, 0.05, 0.02));
  EXPECT_EQ(filter->hypotheses().size(), 200);
}

/// By recovery, that is: alone it stays, and says that nothing fits.
TEST(EkfIcp, StaysWhereItIsAfterBeingCarriedAway) {
  const auto filter = makeEkf();
  filter->reset(roughly(kPlace));
  filter->update({}, seenAt(kPlace));
  const Pose2 elsewhere{8.0, 3.5, 2.0};
  Estimate estimate;
  for (int k = 0; k < 6; ++k) estimate = filter->update({}, seenAt(elsewhere));
  EXPECT_THAT(estimate.T_map_base, PoseNear(kPlace, 0.3, 0.3));
  EXPECT_FALSE(filter->match()->isGood());
}

/// A slip in a turn: match after match says so, and at last they are believed.
TEST(EkfIcp, BelievesMatchesThatOnlyOdometryGainsays) {
  const auto filter = makeEkf();
  const Pose2 slipped = kPlace * Pose2{0.0, 0.0, 0.1};
  filter->reset(Gaussian2{kPlace, Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal()});
  Estimate estimate;
  for (int k = 0; k < 10; ++k) estimate = filter->update({}, seenAt(slipped));
  EXPECT_THAT(estimate.T_map_base, PoseNear(slipped, 0.05, 0.02));
}

}  // namespace
}  // namespace adaptive_localization
