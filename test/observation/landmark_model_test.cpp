// SPDX-License-Identifier: BSD-3-Clause
#include "observation/landmark_model.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const Pose2 kTruth{2.0, 2.0, 0.4};
const Eigen::Vector2d kPost(4.0, 3.0), kTwinPost(1.0, 1.0), kCorner(3.0, 1.0);
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A room of 10 m by 5 m, empty.
std::shared_ptr<const OccupancyGrid> room() {
  return std::make_shared<const OccupancyGrid>(Lattice(100, 50, 0.1, {}),
                                               std::vector<std::int8_t>(5000, 0));
}

Sighting seenAt(const Pose2& pose, const Eigen::Vector2d& place, int id) {
  const Eigen::Vector2d point = inverse(pose) * place;
  return {id, point.norm(), std::atan2(point.y(), point.x()), 0.1, 0.05};
}

Observations seeing(const std::vector<Sighting>& sightings) {
  Observations observations;
  observations.landmarks = sightings;
  return observations;
}

class Model : public testing::Test {
 protected:
  LandmarkModel model() const {
    const LandmarkMap map({{0, kPost}, {0, kTwinPost}, {1, kCorner}});
    return {options_, map, room_, std::make_shared<const DistanceField>(*room_)};
  }

  double scoreAt(const Pose2& pose, const Observations& observations) const {
    Particles particles(1);
    particles.setPose(0, pose);
    Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(1);
    model().score(observations, particles, log_likelihood);
    return log_likelihood[0];
  }

  LandmarkOptions options_;
  std::shared_ptr<const OccupancyGrid> room_ = room();
};

TEST_F(Model, IsLikeliestWhereTheSightingWasMade) {
  const Observations seen = seeing({seenAt(kTruth, kPost, 0), seenAt(kTruth, kCorner, 1)});
  const double best = scoreAt(kTruth, seen);
  for (const Pose2& off : {Pose2{0.3, 0.0, 0.0}, Pose2{0.0, -0.3, 0.0}, Pose2{0.0, 0.0, 0.2}}) {
    EXPECT_LT(scoreAt(kTruth * off, seen), best - 0.5);
  }
}

TEST_F(Model, WeighsAllCandidatesOrTakesTheLikeliest) {
  const Observations post = seeing({seenAt(kTruth, kPost, 0)});
  const double f = options_.landmark_false_share;
  EXPECT_NEAR(scoreAt(kTruth, post), std::log((1 - f) * 0.5 + f), 1e-6);  // one of two fits
  options_.landmark_association = "nearest";
  EXPECT_NEAR(scoreAt(kTruth, post), 0.0, 1e-6);
  EXPECT_NEAR(scoreAt(kTruth, seeing({seenAt(kTruth, kCorner, -1)})), 0.0, 1e-6);
}

TEST_F(Model, HasTheFormOfItsSource) {
  options_.landmark_association = "nearest_distance";
  options_.landmark_likelihood = "exponential";
  options_.landmark_false_share = 0.0;
  Sighting sighting = seenAt(kTruth, kPost, 0);
  sighting.range += 0.2;
  sighting.bearing += 0.1;
  EXPECT_NEAR(scoreAt(kTruth, seeing({sighting})), -0.5 * 0.2 - 0.5 * 0.1, 1e-9);
}

TEST_F(Model, AFalseSightingRulesOutNothing) {
  const double f = options_.landmark_false_share;
  EXPECT_NEAR(scoreAt(kTruth, seeing({{1, 4.5, 3.0, 0.1, 0.05}})), std::log(f), 1e-3);
}

TEST_F(Model, ALandmarkThatShouldBeSightedAndIsNotSpeaksAgainstAPlace) {
  options_.landmark_max_range = 5.0;
  options_.landmark_view = kPi;
  const Observations nothing = seeing({});
  const Pose2 away{2.0, 2.0, kPi};  // only the twin post at (1, 1) is before it
  const Pose2 blind{9.5, 4.5, 0.5};
  EXPECT_NEAR(scoreAt(blind, nothing), 0.0, 1e-12);
  EXPECT_NEAR(scoreAt(away, nothing), std::log(options_.landmark_miss_share), 1e-9);
  options_.landmark_max_range = 0.0;
  EXPECT_EQ(scoreAt(away, nothing), 0.0);
}

TEST_F(Model, AWallHidesALandmark) {
  options_.landmark_max_range = 5.0;
  options_.landmark_view = kPi;
  std::vector<std::int8_t> cells(5000, 0);
  for (int row = 0; row < 20; ++row) cells[static_cast<std::size_t>(row * 100 + 15)] = 100;
  room_ = std::make_shared<const OccupancyGrid>(Lattice(100, 50, 0.1, {}), cells);
  EXPECT_EQ(scoreAt({2.0, 1.2, kPi}, seeing({})), 0.0);
}

TEST_F(Model, JacobiansAreThoseOfRangeAndBearing) {
  constexpr double kStep = 1e-6;
  const Observations seen = seeing({seenAt({2.1, 1.9, 0.45}, kPost, 0)});
  const auto at = model().linearized(seen, kTruth);
  ASSERT_THAT(at, SizeIs(1));
  const Pose2 steps[] = {{kStep, 0, 0}, {0, kStep, 0}, {0, 0, kStep}};
  for (int axis = 0; axis < 3; ++axis) {
    const Pose2& step = steps[axis];
    const Pose2 moved{kTruth.x + step.x, kTruth.y + step.y, kTruth.theta + step.theta};
    const auto next = model().linearized(seen, moved);
    const Eigen::Vector2d slope = (at[0].innovation - next[0].innovation) / kStep;
    EXPECT_NEAR(slope[0], at[0].H(0, axis), 1e-4);
    EXPECT_NEAR(slope[1], at[0].H(1, axis), 1e-4);
  }
  EXPECT_NEAR(at[0].R(0, 0), 0.01, 1e-12);
  EXPECT_NEAR(at[0].R(1, 1), 0.0025, 1e-12);
}

TEST_F(Model, TwoSightingsTellThePlace) {
  const auto poses =
      model().explanations(seeing({seenAt(kTruth, kPost, 0), seenAt(kTruth, kCorner, 1)}), false);
  EXPECT_THAT(poses, testing::Contains(PoseNear(kTruth, 1e-6, 1e-6)));
  EXPECT_LE(poses.size(), 2U);
}

TEST_F(Model, OneSightingTellsACircle) {
  const Observations seen = seeing({seenAt(kTruth, kCorner, 1)});
  EXPECT_THAT(model().explanations(seen, false), IsEmpty());
  const auto poses = model().explanations(seen, true);
  EXPECT_GT(poses.size(), 30U);
  for (const Pose2& pose : poses) {
    EXPECT_NEAR((Eigen::Vector2d(pose.x, pose.y) - kCorner).norm(), seen.landmarks->front().range,
                1e-9);
    EXPECT_NEAR(*model().misfit(seen, pose), 0.0, 1e-6);
  }
  EXPECT_THAT(poses, testing::Contains(PoseNear(kTruth, 0.3, 0.3)));
}

TEST_F(Model, MisfitGrowsWithDeviationsUpToALimit) {
  const Observations seen = seeing({seenAt(kTruth, kCorner, 1)});
  EXPECT_NEAR(*model().misfit(seen, kTruth), 0.0, 1e-9);
  EXPECT_NEAR(*model().misfit(seen, kTruth * Pose2{0, 0, 0.05}), 0.05, 1e-9);
  EXPECT_NEAR(*model().misfit(seen, {9.0, 4.0, 3.0}), 0.3, 1e-9);
}

TEST_F(Model, WhatMakesNoSenseSaysNothing) {
  const Sighting good = seenAt(kTruth, kCorner, 1);
  for (int spoil = 0; spoil < 6; ++spoil) {
    Sighting bad = good;
    if (spoil == 0) bad.range = kNan;
    if (spoil == 1) bad.bearing = kNan;
    if (spoil == 2) bad.range_deviation = 0.0;
    if (spoil == 3) bad.bearing_deviation = kNan;
    if (spoil == 4) bad.id = 17;
    if (spoil == 5) bad.range = -1.0;
    const Observations seen = seeing({bad});
    EXPECT_EQ(scoreAt(kTruth, seen), 0.0) << spoil;
    EXPECT_THAT(model().linearized(seen, kTruth), IsEmpty());
    EXPECT_THAT(model().explanations(seen, true), IsEmpty());
    EXPECT_FALSE(model().misfit(seen, kTruth));
    EXPECT_FALSE(model().canLocalize(seen));
  }
  EXPECT_TRUE(model().canLocalize(seeing({good})));
  EXPECT_TRUE(model().namesPlaces(seeing({good})));
  EXPECT_FALSE(model().namesPlaces({}));
  EXPECT_FALSE(model().canLocalize({}));
}

}  // namespace
}  // namespace adaptive_localization
