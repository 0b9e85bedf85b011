// SPDX-License-Identifier: BSD-3-Clause
#include "match/line_matcher.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "line_toys.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

Pose2 near(const Pose2& pose, Rng& rng) {
  return {pose.x + rng.normal(0, 0.1), pose.y + rng.normal(0, 0.1),
          wrapAngle(pose.theta + rng.normal(0, 0.05))};
}

TEST(LineMatcher, FindsThePoseOfAScanWithoutNoise) {
  const LineMatcher matcher(exactly(1e-4), room());
  Rng rng(1);
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const Pose2 pose{rng.uniform(1, 5), rng.uniform(1, 3), rng.uniform(-kPi, kPi)};
    const Match match = matcher.match(near(pose, rng), ToyLaser{}.scan(pose, room(), rng));
    if (match.H.rows() < 3) continue;  // sees parallel walls only
    ASSERT_TRUE(match.isGood()) << toText(match.fault);
    ASSERT_THAT(match.T_map_base, PoseNear(pose, 1e-4, 1e-4));
    ASSERT_GT(match.inlier_ratio, 0.6);
    ASSERT_LT(match.mean_distance, 1e-4);
    ++found;
  }
  EXPECT_GT(found, 80);
}

TEST(LineMatcher, RowsAreAsSureAsTheySay) {
  ToyLaser laser;
  laser.noise = 0.03;
  const LineMatcher matcher(exactly(), room());
  Rng rng(2);
  double sum = 0.0;
  int rows = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose2 pose{rng.uniform(1, 5), rng.uniform(1, 3), rng.uniform(-kPi, kPi)};
    const Match match = matcher.match(near(pose, rng), laser.scan(pose, room(), rng));
    if (!match.isGood()) continue;
    const Eigen::Vector3d error(match.T_map_base.x - pose.x, match.T_map_base.y - pose.y,
                                wrapAngle(match.T_map_base.theta - pose.theta));
    const Match::Vector off = match.H * error + match.rest;
    sum += off.cwiseAbs2().cwiseQuotient(match.variance).sum();
    rows += static_cast<int>(match.H.rows());
  }
  EXPECT_GT(rows, 1200);
  EXPECT_GT(sum / rows, 0.8);
  EXPECT_LT(sum / rows, 1.3);
}

TEST(LineMatcher, AlongACorridorNothingIsSaid) {
  const std::vector<Segment> corridor{{{-50, 0}, {50, 0}}, {{50, 2}, {-50, 2}}};
  const LineMatcher matcher({}, corridor);
  Rng rng(3);
  const Pose2 pose{0, 0.9, 0.1}, guess{0.1, 0.95, 0.08};
  LaserScan message = ToyLaser{}.message(pose, corridor, rng);
  message.range_max = 8.0;
  const Match match = matcher.match(guess, toScan(message, ToyLaser{}.mount, {}));
  ASSERT_TRUE(match.isGood()) << toText(match.fault);
  EXPECT_EQ(match.H.rows(), 2);
  EXPECT_NEAR(match.T_map_base.x, guess.x, 1e-6);
  EXPECT_THAT(match.T_map_base, PoseNear(Pose2{guess.x, pose.y, pose.theta}, 1e-2, 1e-2));
  EXPECT_LT((match.information() * Eigen::Vector3d::UnitX()).norm(), 1e-3);
}

TEST(LineMatcher, PeopleDoNotFitAndDoNotPull) {
  ToyLaser laser;
  laser.noise = 0.01;
  LineOptions options;
  options.line_range_std = 0.01;
  const LineMatcher matcher(options, room());
  const Pose2 pose{2, 2, 0.2};
  laser.people = {{{3, 2}, 0.25}, {{3.2, 3}, 0.25}, {{2.4, 1}, 0.25}};
  Rng rng(4);
  const Scan scan = laser.scan(pose, room(), rng);
  const Match match = matcher.match({2.05, 1.95, 0.22}, scan);
  ASSERT_TRUE(match.isGood()) << toText(match.fault);
  EXPECT_THAT(match.T_map_base, PoseNear(pose, 0.02, 0.01));
  ASSERT_EQ(match.fits.size(), static_cast<std::size_t>(scan.hits()));
  int of_people = 0;
  for (int i = 0; i < scan.hits(); ++i) {
    const Eigen::Vector2d hit = pose * Eigen::Vector2d(scan.x[i], scan.y[i]);
    for (const auto& person : laser.people) {
      if ((hit - person.centre).norm() > 0.4) continue;
      ++of_people;
      EXPECT_FALSE(match.fits[static_cast<std::size_t>(i)]) << hit.transpose();
    }
  }
  EXPECT_GT(of_people, 20);
}

TEST(LineMatcher, SaysWhyNothingIsMatched) {
  const LineMatcher matcher({}, room());
  Rng rng(5);
  const Scan scan = ToyLaser{}.scan({2, 2, 0}, room(), rng);
  EXPECT_EQ(matcher.match({2, 2, 0}, scan).fault, MatchFault::kNone);
  EXPECT_EQ(matcher.match({2, 2, 0}, Scan{}).fault, MatchFault::kFewHits);
  EXPECT_EQ(matcher.match({3, 3, 1}, scan).fault, MatchFault::kOutliers);
  EXPECT_EQ(LineMatcher({}, {}).match({2, 2, 0}, scan).fault, MatchFault::kOutliers);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Pose2& guess : {Pose2{nan, 2, 0}, Pose2{2, 2, nan}}) {
    const Match match = matcher.match(guess, scan);
    EXPECT_EQ(match.fault, MatchFault::kNoGuess);
    EXPECT_TRUE(isFinite(match.T_map_base));
  }
  LineOptions vague;
  vague.line_map_std = 2.0;
  vague.line_map_turn_std = 1.0;
  const Match told = LineMatcher(vague, room()).match({2, 2, 0}, scan);
  EXPECT_EQ(told.fault, MatchFault::kSingular) << "walls that may be anywhere";
  for (const Eigen::Matrix3d& prior :
       {Eigen::Matrix3d(Eigen::Matrix3d::Constant(nan)), Eigen::Matrix3d(Eigen::Matrix3d::Ones()),
        Eigen::Matrix3d(-Eigen::Matrix3d::Identity())}) {
    const Match match = matcher.match({2, 2, 0}, scan, prior);
    EXPECT_TRUE(isFinite(match.T_map_base));
    EXPECT_TRUE(match.H.allFinite() && match.variance.allFinite());
  }
}

/// Where a prior tells nothing of a direction, lines are looked for as they are without one.
TEST(LineMatcher, APriorOfSomeDirectionsIsEnough) {
  const LineMatcher matcher(exactly(1e-4), room());
  Rng rng(6);
  const Pose2 pose{2, 2, 0.2};
  const Scan scan = ToyLaser{}.scan(pose, room(), rng);
  for (const Eigen::Vector3d& diagonal :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(100, 100, 0), Eigen::Vector3d(0, 0, 100),
        Eigen::Vector3d(0, 100, 0), Eigen::Vector3d(100, -1e-9, 100)}) {
    const Eigen::Matrix3d prior = diagonal.asDiagonal();
    const Match match = matcher.match({2.05, 1.95, 0.22}, scan, prior);
    ASSERT_TRUE(match.isGood()) << diagonal.transpose() << ": " << toText(match.fault);
    EXPECT_THAT(match.T_map_base, PoseNear(pose, 1e-4, 1e-4)) << diagonal.transpose();
  }
  const Eigen::Vector3d slanted(1, 1, 0);
  const Eigen::Matrix3d prior = 100 * slanted * slanted.transpose();
  EXPECT_TRUE(matcher.match({2.05, 1.95, 0.22}, scan, prior).isGood());
}

}  // namespace
}  // namespace adaptive_localization
