// SPDX-License-Identifier: BSD-3-Clause
#include "match/line_features.hpp"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "line_toys.hpp"
#include "match/line_map.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Ge;
using testing::IsEmpty;
using testing::Le;
using testing::SizeIs;

/// How far a line is off the nearest of the walls as seen from a pose: over (rho, alpha).
Eigen::Vector2d errorOf(const ScanLine& line, const Pose2& T_map_base,
                        const std::vector<Segment>& walls) {
  Eigen::Vector2d least(1e3, 1e3);
  const LineMap map(walls);
  for (const auto& landmark : map.lines()) {
    LineMatch match;
    match.z = {line.rho, line.alpha};
    match.landmark = landmark;
    const Eigen::Vector2d error = match.innovationAt(T_map_base);
    if (error.norm() < least.norm()) least = error;
  }
  return least;
}

/// Metres from a point to the nearest wall.
double toWalls(const Eigen::Vector2d& point, const std::vector<Segment>& walls) {
  double least = 1e3;
  for (const auto& wall : walls) least = std::min(least, distance(wall, point));
  return least;
}

Pose2 poseInRoom(Rng& rng) {
  return {rng.uniform(0.5, 5.5), rng.uniform(0.5, 3.5), rng.uniform(-kPi, kPi)};
}

TEST(LinesOf, ARoomAreItsWallsWithoutNoise) {
  ToyLaser laser;
  laser.is_round = true;
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    const Pose2 pose = poseInRoom(rng);
    const auto lines = linesOf(laser.scan(pose, room(), rng), exactly(1e-4));
    ASSERT_THAT(lines, SizeIs(AllOf(Ge(4U), Le(5U))));  // the one behind is cut where the scan is
    std::size_t points = 0;
    double length = 0.0;
    for (const auto& line : lines) {
      ASSERT_LT(errorOf(line, pose, room()).norm(), 1e-5) << "rho " << line.rho;
      points += line.hits.size();
      length += line.length();
    }
    EXPECT_GT(points, 340U);
    EXPECT_GT(length, 16.0);
    EXPECT_LT(length, 20.001);
  }
}

TEST(LinesOf, AnglesAndDistancesTurnWithTheRobotAndNotWithTheMount) {
  Rng rng(2);
  ToyLaser level, upside_down;
  level.is_round = upside_down.is_round = true;
  upside_down.mount = LaserMount::upsideDown({-0.2, 0.05, 0.7});
  for (int i = 0; i < 50; ++i) {
    const Pose2 pose = poseInRoom(rng);
    const double turn = rng.uniform(-kPi, kPi);
    const Pose2 turned{pose.x, pose.y, wrapAngle(pose.theta + turn)};
    const auto lines = linesOf(level.scan(pose, room(), rng), exactly(1e-4));
    const auto seen_turned = linesOf(level.scan(turned, room(), rng), exactly(1e-4));
    const auto seen_upside_down = linesOf(upside_down.scan(turned, room(), rng), exactly(1e-4));
    ASSERT_GE(lines.size(), 4U);
    for (const auto* others : {&seen_turned, &seen_upside_down}) {
      for (const auto& line : lines) {
        const bool found = std::any_of(others->begin(), others->end(), [&](const ScanLine& other) {
          return std::abs(wrapAngle(other.alpha - (line.alpha - turn))) < 1e-5 &&
                 std::abs(other.rho - line.rho) < 1e-5;
        });
        ASSERT_TRUE(found) << "round " << i << " rho " << line.rho << " alpha " << line.alpha;
      }
    }
  }
}

TEST(LinesOf, CovarianceIsThatOfTheErrors) {
  ToyLaser laser;
  laser.noise = 0.03;
  Rng rng(3);
  double sum = 0.0;
  int lines = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (int i = 0; i < 400; ++i) {
    const Pose2 pose = poseInRoom(rng);
    for (const auto& line : linesOf(laser.scan(pose, room(), rng), {})) {
      const Eigen::Vector2d error = errorOf(line, pose, room());
      sum += error.dot(line.covariance.inverse() * error);
      mean += line.covariance.llt().matrixL().solve(error);
      ++lines;
    }
  }
  EXPECT_GT(lines, 800);
  // A chi-square of two degrees of freedom: mean 2; hits of the next wall beside a corner add some.
  EXPECT_GT(sum / lines, 1.6);
  EXPECT_LT(sum / lines, 2.6);
  EXPECT_LT((mean / lines).norm(), 0.2) << (mean / lines).transpose();
}

TEST(LinesOf, MorePointsAndLessNoiseMakeItSurer) {
  Rng rng(4);
  LineOptions sharp, dull;
  sharp.line_range_std = 0.01;
  const Scan scan = ToyLaser{}.scan({2, 2, 0.3}, room(), rng);
  const auto sure = linesOf(scan, sharp);
  const auto unsure = linesOf(scan, dull);
  ASSERT_EQ(sure.size(), unsure.size());
  for (std::size_t i = 0; i < sure.size(); ++i) {
    EXPECT_NEAR(unsure[i].covariance(0, 0), 9.0 * sure[i].covariance(0, 0),
                1e-6 * unsure[i].covariance(0, 0));
  }
}

TEST(LinesOf, PeopleMakeNone) {
  ToyLaser laser;
  laser.is_round = true;
  laser.noise = 0.01;
  LineOptions options;
  options.line_range_std = 0.01;
  Rng rng(5);
  int people_seen = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 pose = poseInRoom(rng);
    laser.people.clear();
    while (laser.people.size() < 4) {
      const Person person{{rng.uniform(0.3, 5.7), rng.uniform(0.3, 3.7)}, 0.25};
      if ((person.centre - Eigen::Vector2d(pose.x, pose.y)).norm() > 0.6) {
        laser.people.push_back(person);
      }
    }
    people_seen += 4;
    for (const auto& line : linesOf(laser.scan(pose, room(), rng), options)) {
      for (const auto& end : {line.a, line.b}) {
        ASSERT_LT(toWalls(pose * end, room()), 0.05) << "round " << i << ": " << line.hits.size();
      }
    }
  }
  EXPECT_EQ(people_seen, 800);
}

TEST(LinesOf, SingleWrongHitsDoNotCutAWall) {
  Rng rng(6);
  ToyLaser laser;
  for (int i = 0; i < 50; ++i) {
    LaserScan message = laser.message({1, 2, 0}, room(), rng);
    for (int k = 0; k < 181; k += 10) message.ranges[static_cast<std::size_t>(k + i % 10)] *= 0.5F;
    ScanOptions options;
    options.laser_max_beams = 360;
    const auto lines = linesOf(toScan(message, laser.mount, options), exactly(1e-4));
    EXPECT_THAT(lines, SizeIs(3));
    for (const auto& line : lines) EXPECT_LT(errorOf(line, {1, 2, 0}, room()).norm(), 1e-5);
  }
}

TEST(LinesOf, TooFewOrTooShortAreNone) {
  Rng rng(7);
  ToyLaser laser;
  const Scan scan = laser.scan({2, 2, 0}, room(), rng);
  LineOptions options;
  options.line_least_points = 182;
  EXPECT_THAT(linesOf(scan, options), IsEmpty());
  options = {};
  options.line_least_length = 6.1;
  EXPECT_THAT(linesOf(scan, options), IsEmpty());
  EXPECT_THAT(linesOf(Scan{}, {}), IsEmpty());
}

TEST(LinesOf, NothingComesOutThatIsNotFinite) {
  Rng rng(8);
  LineOptions options;
  options.line_least_points = 3;
  options.line_least_length = 1e-3;
  const float odd[] = {0.0F, NAN, INFINITY, -INFINITY, 1e30F, -1e30F, 1e-30F};
  std::size_t lines = 0;
  for (int round = 0; round < 500; ++round) {
    const auto hits = static_cast<Eigen::Index>(rng.below(60));
    Scan scan;
    const double spread = rng.uniform() < 0.2 ? 0.0 : rng.uniform(0.0, 3.0);
    scan.x = scan.y = scan.range = scan.bearing = Eigen::ArrayXf::Zero(hits);
    for (Eigen::Index i = 0; i < hits; ++i) {
      for (auto* values : {&scan.x, &scan.y, &scan.range, &scan.bearing}) {
        (*values)[i] =
            rng.uniform() < 0.03 ? odd[rng.below(7)] : static_cast<float>(rng.uniform(0.0, spread));
      }
      if (rng.uniform() < 0.9) scan.bearing[i] = static_cast<float>(i) * 0.02F;
      scan.range[i] = std::max(scan.range[i], 1.0F);
    }
    for (const auto& line : linesOf(scan, options)) {
      ++lines;
      ASSERT_TRUE(std::isfinite(line.rho) && std::isfinite(line.alpha) && line.a.allFinite() &&
                  line.b.allFinite() && line.covariance.allFinite());
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(line.covariance);
      ASSERT_GE(solver.eigenvalues().minCoeff(), -1e-9 * solver.eigenvalues().maxCoeff());
      ASSERT_GE(line.hits.size(), 3U);
    }
  }
  EXPECT_GT(lines, 20U);
}

}  // namespace
}  // namespace adaptive_localization
