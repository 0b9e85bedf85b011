// SPDX-License-Identifier: BSD-3-Clause
#include "match/line_map.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <limits>

#include "line_toys.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

Eigen::Matrix3d covarianceOf(double metres, double radians) {
  return Eigen::Vector3d(metres * metres, metres * metres, radians * radians).asDiagonal();
}

/// The pose that the matches make most likely; of a uniform belief.
Gaussian2 solve(const Pose2& guess, const std::vector<LineMatch>& matches) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  for (const auto& match : matches) {
    information += match.H.transpose() * match.R.inverse() * match.H;
    pull += match.H.transpose() * match.R.inverse() * match.innovation;
  }
  const Eigen::Vector3d step = information.inverse() * pull;
  return {{guess.x + step.x(), guess.y + step.y(), wrapAngle(guess.theta + step.z())},
          information.inverse()};
}

/// Whether the walls matched are not all parallel.
bool areEnough(const std::vector<LineMatch>& matches) {
  return std::any_of(matches.begin(), matches.end(), [&](const LineMatch& match) {
    return std::abs(match.landmark.normal.dot(matches.front().landmark.normal)) < 0.5;
  });
}

Pose2 moved(const Pose2& pose, double metres, double radians, Rng& rng) {
  return {pose.x + rng.normal(0, metres), pose.y + rng.normal(0, metres),
          wrapAngle(pose.theta + rng.normal(0, radians))};
}

TEST(LineMap, NormalsPointIntoTheWalls) {
  const LineMap map(room());
  ASSERT_THAT(map.lines(), SizeIs(4));
  for (const auto& line : map.lines()) {
    EXPECT_NEAR(line.rho - line.normal.dot(Eigen::Vector2d(3, 2)),
                distance(line.segment, Eigen::Vector2d(3, 2)), 1e-12);
  }
  EXPECT_THAT(LineMap({{{1, 1}, {1, 1}}}).lines(), IsEmpty());
}

TEST(MatchLines, WithoutNoiseTheyLeadToTheRightPose) {
  ToyLaser laser;
  const LineMap map(room());
  const LineOptions options = exactly(1e-4);
  Rng rng(1);
  int solved = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 pose{rng.uniform(1, 5), rng.uniform(1, 3), rng.uniform(-kPi, kPi)};
    const Pose2 guess = moved(pose, 0.1, 0.05, rng);
    const auto lines = linesOf(laser.scan(pose, room(), rng), options);
    const auto matches = matchLines(guess, covarianceOf(0.1, 0.05), lines, map, options);
    if (!areEnough(matches)) continue;  // too far off for this belief
    ++solved;
    ASSERT_THAT(solve(guess, matches).mean, PoseNear(pose, 1e-4, 1e-4));
    for (const auto& match : matchLines(pose, covarianceOf(0.1, 0.05), lines, map, options)) {
      ASSERT_LT(match.innovation.norm(), 1e-4);
    }
  }
  EXPECT_GT(solved, 150);
}

TEST(MatchLines, JacobianIsTheNumericOne) {
  Rng rng(2);
  const Pose2 pose{1.3, 2.1, 3.1};
  const auto lines = linesOf(ToyLaser{}.scan(pose, room(), rng), {});
  const auto matches = matchLines(pose, covarianceOf(0.1, 0.05), lines, LineMap(room()), exactly());
  ASSERT_GE(matches.size(), 2U);
  constexpr double kStep = 1e-6;
  for (const auto& match : matches) {
    for (int k = 0; k < 3; ++k) {
      Pose2 more = pose, less = pose;
      (k == 0 ? more.x : k == 1 ? more.y : more.theta) += kStep;
      (k == 0 ? less.x : k == 1 ? less.y : less.theta) -= kStep;
      const Eigen::Vector2d slope =
          -(match.innovationAt(more) - match.innovationAt(less)) / (2.0 * kStep);
      EXPECT_LT((slope - match.H.col(k)).norm(), 1e-6) << "column " << k;
    }
    EXPECT_EQ(match.innovation, match.innovationAt(pose));
    EXPECT_EQ(match.R, lines[static_cast<std::size_t>(match.scan_line)].covariance);
  }
}

TEST(MatchLines, PosesFromThemAreAsSureAsTheySay) {
  ToyLaser laser;
  laser.noise = 0.03;
  const LineMap map(room());
  Rng rng(3);
  double sum = 0.0;
  int runs = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose2 pose{rng.uniform(1, 5), rng.uniform(1, 3), rng.uniform(-kPi, kPi)};
    const Pose2 guess = moved(pose, 0.05, 0.02, rng);
    const auto lines = linesOf(laser.scan(pose, room(), rng), {});
    const auto matches = matchLines(guess, covarianceOf(0.05, 0.02), lines, map, exactly());
    if (!areEnough(matches)) continue;
    const Gaussian2 found = solve(guess, matches);
    const Eigen::Vector3d error(found.mean.x - pose.x, found.mean.y - pose.y,
                                wrapAngle(found.mean.theta - pose.theta));
    sum += error.dot(found.covariance.inverse() * error);
    ++runs;
  }
  EXPECT_GT(runs, 400);
  EXPECT_GT(sum / runs, 2.5);  // three degrees of freedom
  EXPECT_LT(sum / runs, 3.9);
}

TEST(MatchLines, InTheMazeAmongPeopleWhatMatchesIsRight) {
  const auto walls = maze();
  const LineMap map(walls);
  ToyLaser laser;
  laser.noise = 0.01;
  LineOptions options;
  options.line_range_std = 0.01;
  Rng rng(4);
  int matched = 0, wrong = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose2 pose{rng.uniform(0.6, 2.6), rng.uniform(0.6, 2.8), rng.uniform(-kPi, kPi)};
    laser.people.clear();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d away =
          Eigen::Rotation2Dd(rng.uniform(-kPi, kPi)) * Eigen::Vector2d(rng.uniform(0.6, 1.5), 0);
      laser.people.push_back({Eigen::Vector2d(pose.x, pose.y) + away, 0.2});
    }
    const auto lines = linesOf(laser.scan(pose, walls, rng), options);
    const Pose2 guess = moved(pose, 0.05, 0.03, rng);
    for (const auto& match : matchLines(guess, covarianceOf(0.05, 0.03), lines, map, options)) {
      ++matched;
      const Eigen::Vector2d error = match.innovationAt(pose);
      if (error.dot(match.R.inverse() * error) > 25.0) ++wrong;
    }
  }
  EXPECT_GT(matched, 600);
  EXPECT_LE(wrong, matched / 100);
}

TEST(MatchLines, AWallIsNotTakenForItsOtherFace) {
  const std::vector<Segment> board{{{4, 1}, {0, 1}}, {{0, 1.05}, {4, 1.05}}};  // free below, above
  Rng rng(5);
  const Pose2 below{2, 0, kPi / 2};
  const auto lines = linesOf(ToyLaser{}.scan(below, board, rng), {});
  ASSERT_THAT(lines, SizeIs(1));
  const auto matches = matchLines(below, covarianceOf(0.5, 0.3), lines, LineMap(board), {});
  ASSERT_THAT(matches, SizeIs(1));
  EXPECT_EQ(matches[0].map_line, 0);
  const LineMap back({board[1]});
  EXPECT_THAT(matchLines(below, covarianceOf(0.5, 0.3), lines, back, {}), IsEmpty());
}

TEST(MatchLines, ALineThatTwoOfTheMapExplainIsLeftOut) {
  const Segment wall{{4, 2}, {0, 2}}, rival{{4, 2.1}, {0, 2.1}};
  Rng rng(6);
  const Pose2 pose{2, 0, kPi / 2};
  const auto lines = linesOf(ToyLaser{}.scan(pose, {wall}, rng), {});
  ASSERT_THAT(lines, SizeIs(1));
  const LineMap both({wall, rival});
  EXPECT_THAT(matchLines(pose, covarianceOf(0.3, 0.05), lines, both, {}), IsEmpty());
  EXPECT_THAT(matchLines(pose, covarianceOf(0.01, 0.01), lines, both, {}), SizeIs(1));
  const LineMap two_pieces({{{4, 2}, {1.99, 2}}, {{2.01, 2}, {0, 2}}});
  LineOptions options;
  options.line_overlap = 0.4;
  EXPECT_THAT(matchLines(pose, covarianceOf(0.3, 0.05), lines, two_pieces, options), SizeIs(1));
}

TEST(MatchLines, ALineBesideAWallOfTheMapIsNone) {
  Rng rng(7);
  const Pose2 pose{2, 0, kPi / 2};
  const auto lines = linesOf(ToyLaser{}.scan(pose, {{{4, 2}, {0, 2}}}, rng), {});
  const Eigen::Matrix3d covariance = covarianceOf(0.05, 0.05);
  EXPECT_THAT(matchLines(pose, covariance, lines, LineMap({{{9, 2}, {5, 2}}}), {}), IsEmpty());
  EXPECT_THAT(matchLines(pose, covariance, lines, LineMap({{{9, 2}, {0.5, 2}}}), {}), SizeIs(1));
}

TEST(MatchLines, ErrorsThatHitsShareDoNotPartWallsFromTheirLines) {
  ToyLaser laser;
  laser.noise = 0.01;
  Rng rng(10);
  const Pose2 pose{2, 2, 0.3};
  LaserScan message = laser.message(pose, room(), rng);
  for (float& range : message.ranges) range += 0.02F;  // as lasers err when they are warm
  const Scan scan = toScan(message, laser.mount, {});
  const LineMap map(room());
  const Eigen::Matrix3d sure = covarianceOf(0.003, 0.002);
  LineOptions options = exactly(0.01);
  const auto lines = linesOf(scan, options);
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_THAT(matchLines(pose, sure, lines, map, options), IsEmpty());
  options.line_map_std = 0.01;
  const auto matches = matchLines(pose, sure, lines, map, options);
  ASSERT_THAT(matches, SizeIs(3));
  const auto& line = lines[static_cast<std::size_t>(matches[0].scan_line)];
  EXPECT_NEAR(matches[0].R(0, 0), line.covariance(0, 0) + 1e-4, 1e-12);
  EXPECT_EQ(matches[0].R(1, 1), line.covariance(1, 1));
}

TEST(MatchLines, HeadingsWrapAtHalfATurn) {
  Rng rng(8);
  const Pose2 pose{2, 2, kPi - 0.01}, guess{2, 2, -kPi + 0.01};
  const auto lines = linesOf(ToyLaser{}.scan(pose, room(), rng), {});
  const auto matches = matchLines(guess, covarianceOf(0.1, 0.05), lines, LineMap(room()), {});
  ASSERT_GE(matches.size(), 2U);
  EXPECT_THAT(solve(guess, matches).mean, PoseNear(pose, 1e-4, 1e-4));
}

TEST(MatchLines, ABeliefThatIsNoneMatchesNothing) {
  Rng rng(9);
  const auto lines = linesOf(ToyLaser{}.scan({2, 2, 0}, room(), rng), {});
  const LineMap map(room());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(matchLines({nan, 2, 0}, covarianceOf(0.1, 0.1), lines, map, {}), IsEmpty());
  EXPECT_THAT(matchLines({2, 2, 0}, covarianceOf(nan, 0.1), lines, map, {}), IsEmpty());
  EXPECT_THAT(matchLines({2, 2, 0}, -covarianceOf(1, 1), lines, map, {}), IsEmpty());
  EXPECT_THAT(matchLines({2, 2, 0}, covarianceOf(0.1, 0.1), lines, LineMap({}), {}), IsEmpty());
}

}  // namespace
}  // namespace adaptive_localization
