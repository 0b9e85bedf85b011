// SPDX-License-Identifier: BSD-3-Clause
#include "match/scan_matcher.hpp"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "scan_toys.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

class EveryOutlierRule : public testing::TestWithParam<const char*> {};

TEST_P(EveryOutlierRule, FindsThePoseOfAScanWithoutNoise) {
  const ScanMatcher matcher(with("line", GetParam()), surfacesOf(roomLines()));
  const Scan scan = scanAt(kTruth, roomLines());
  Rng rng(7);
  for (int k = 0; k < 100; ++k) {
    const Pose2 guess =
        kTruth * Pose2{rng.uniform(-0.15, 0.15), rng.uniform(-0.15, 0.15), rng.uniform(-0.1, 0.1)};
    const Match match = matcher.match(guess, scan);
    ASSERT_TRUE(match.isGood()) << toText(match.fault);
    ASSERT_THAT(match.T_map_base, PoseNear(kTruth, 1e-7, 1e-8)) << k;  // hits are floats
    ASSERT_EQ(match.H.rows(), 3);
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryOutlierRule,
                         testing::Values("none", "kernel", "trim", "ransac"));

class EveryRobustRule : public testing::TestWithParam<const char*> {};

TEST_P(EveryRobustRule, ForgivesFourTenthsOfTheBeams) {
  const ScanMatcher matcher(with("line", GetParam()), surfacesOf(roomLines()));
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Scan scan = scanAt(kTruth, roomLines(), 0.01, seed);
    Rng rng(100 + seed);
    for (Eigen::Index i = 0; i < scan.x.size(); ++i) {
      if (rng.uniform() >= 0.4) continue;
      const auto share = static_cast<float>(rng.uniform(0.2, 0.95));
      scan.x[i] *= share;
      scan.y[i] *= share;
    }
    const Match match = matcher.match(kTruth * Pose2{0.05, -0.05, 0.04}, scan);
    ASSERT_TRUE(match.isGood()) << toText(match.fault);
    worst = std::max(worst, distance(match.T_map_base, kTruth));
  }
  EXPECT_LT(worst, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRobustRule, testing::Values("kernel", "trim", "ransac"));

/// The presets of the sources have one reach: a consensus is sought all the same.
TEST(ScanMatcher, SeeksAConsensusAtAConstantReach) {
  double distances[2];
  int i = 0;
  for (const char* outliers : {"kernel", "ransac"}) {
    MatchOptions options = with("point", outliers);
    options.match_reach = options.match_reach_end = 1.0;
    const ScanMatcher matcher(options, surfacesOf(roomLines()));
    Scan scan = scanAt(kTruth, roomLines(), 0.01, 1);
    for (Eigen::Index k = 0; k < scan.x.size(); k += 3) {
      scan.x[k] *= 0.8F;
      scan.y[k] *= 0.8F;
    }
    const Match match = matcher.match(kTruth * Pose2{0.05, -0.05, 0.04}, scan);
    distances[i++] = distance(match.T_map_base, kTruth);
  }
  EXPECT_NE(distances[0], distances[1]);
  EXPECT_LT(distances[1], 0.02);
}

TEST(ScanMatcher, FindsARotatedCopyFromItsPoints) {
  const ScanMatcher matcher(with("point", "none"), surfacesOf(roomLines()));
  const Match match = matcher.match(kTruth * Pose2{0.02, -0.02, 0.02}, scanAt(kTruth, roomLines()));
  EXPECT_THAT(match.T_map_base, PoseNear(kTruth, 3e-4, 2e-4));
}

TEST(ScanMatcher, NeedsFewerStepsToLinesThanToPoints) {
  const Scan scan = scanAt(kTruth, roomLines());
  const Pose2 guess = kTruth * Pose2{0.1, 0.1, 0.05};
  const auto lines = ScanMatcher(with("line"), surfacesOf(roomLines())).match(guess, scan);
  const auto points = ScanMatcher(with("point"), surfacesOf(roomLines())).match(guess, scan);
  EXPECT_LE(lines.iterations, 8);
  EXPECT_GT(points.iterations, 2 * lines.iterations);
}

TEST(ScanMatcher, LeavesThePoseAlongACorridorAsItWasGuessed) {
  const auto surfaces = std::make_shared<const SurfaceMap>(
      Lattice(400, 60, 0.05, {-10.0, -0.5, 0.0}), corridorLines());
  const ScanMatcher matcher(with("line"), surfaces);
  const Pose2 truth{0.0, 1.1, 0.1};
  const Match match = matcher.match({0.3, 1.0, 0.05}, scanAt(truth, corridorLines(), 0.01, 3));
  ASSERT_TRUE(match.isGood());
  EXPECT_EQ(match.H.rows(), 2);
  EXPECT_NEAR(match.T_map_base.x, 0.3, 1e-12);
  EXPECT_NEAR(match.T_map_base.y, truth.y, 0.005);
  EXPECT_NEAR(match.T_map_base.theta, truth.theta, 0.003);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(match.information());
  EXPECT_NEAR(solver.eigenvalues()[0], 0.0, 1e-12 * solver.eigenvalues()[2]);
}

/// Errors of 400 noisy scans, normalised by what the matches say: chi-square with 3 degrees of
/// freedom has mean 3 and, over 400, a standard deviation of 0.12.
TEST(ScanMatcher, KnowsHowSureItIs) {
  MatchOptions options = with("line");
  options.match_range_std = 0.02;
  options.match_surface_std = 0.002;
  options.match_kernel = 0.2;
  const ScanMatcher matcher(options, surfacesOf(roomLines()));
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const Match match =
        matcher.match(kTruth * Pose2{0.02, 0.02, 0.01}, scanAt(kTruth, roomLines(), 0.02, seed));
    const Pose2& found = match.T_map_base;
    const Eigen::Vector3d error(found.x - kTruth.x, found.y - kTruth.y,
                                wrapAngle(found.theta - kTruth.theta));
    sum += error.dot(match.information() * error);
  }
  EXPECT_NEAR(sum / 400, 3.0, 0.75);
}

/// Gauss-Newton's rows against differences: the information of J is that of the distances.
TEST(ScanMatcher, InformationIsThatOfTheDistances) {
  MatchOptions options = with("line", "none");
  options.match_range_std = 1e-9;
  options.match_surface_std = 0.05;
  const auto lines = roomLines();
  const ScanMatcher matcher(options, surfacesOf(lines));
  const Scan scan = scanAt(kTruth, lines);
  const Match match = matcher.match(kTruth, scan);
  Eigen::Matrix3d numeric = Eigen::Matrix3d::Zero();
  const auto surfaces = surfacesOf(lines);
  const auto residual = [&](const Surface& surface, const Pose2& pose, Eigen::Index i) {
    const Eigen::Vector2d point = pose * Eigen::Vector2d(scan.x[i], scan.y[i]);
    return surface.normal.cast<double>().dot(point - surface.point);
  };
  const double h = 1e-5;
  for (Eigen::Index i = 0; i < scan.x.size(); ++i) {
    if (!match.fits[static_cast<std::size_t>(i)]) continue;
    const Eigen::Vector2d sensor(match.T_map_base.x, match.T_map_base.y);
    const Surface& surface =
        *surfaces->hitBy(sensor, match.T_map_base * Eigen::Vector2d(scan.x[i], scan.y[i]));
    const auto slope = [&](const Pose2& up, const Pose2& down) {
      return (residual(surface, up, i) - residual(surface, down, i)) / (2 * h);
    };
    const Pose2& p = match.T_map_base;
    const Eigen::Vector3d row(slope({p.x + h, p.y, p.theta}, {p.x - h, p.y, p.theta}),
                              slope({p.x, p.y + h, p.theta}, {p.x, p.y - h, p.theta}),
                              slope({p.x, p.y, p.theta + h}, {p.x, p.y, p.theta - h}));
    numeric += row * row.transpose() / (0.05 * 0.05);
  }
  EXPECT_LT((match.information() - numeric).norm(), 1e-5 * numeric.norm());
}

TEST(ScanMatcher, StaysSaneWhateverTheScan) {
  const ScanMatcher matcher(with("line"), surfacesOf(roomLines()));
  Rng rng(11);
  const double odd[] = {std::nan(""), std::numeric_limits<double>::infinity(), 1e30, -1e30, 0.0};
  for (int k = 0; k < 500; ++k) {
    std::vector<Eigen::Vector2d> hits(rng.below(40));
    for (auto& hit : hits) {
      hit = {rng.uniform(-5, 5), rng.uniform(-5, 5)};
      if (rng.uniform() < 0.1) hit.x() = odd[rng.below(5)];
    }
    const Pose2 guess{rng.uniform(-2, 8), rng.uniform(-2, 6), rng.uniform(-4, 4)};
    for (const char* metric : {"line", "point"}) {
      const Match match =
          ScanMatcher(with(metric), surfacesOf(roomLines())).match(guess, hitsAt(hits, 8.0).scan);
      ASSERT_TRUE(isFinite(match.T_map_base)) << k;
      ASSERT_TRUE(match.H.allFinite() && match.variance.allFinite()) << k;
    }
  }
}

/// Scan and map change places: the transform found is the inverse.
TEST(ScanMatcher, SwappingScanAndMapGivesTheInverse) {
  const Pose2 moved{0.12, -0.08, 0.05};
  std::vector<Segment> room, seen;  // from the middle of the room, and from a little beside
  for (const Segment& line : roomLines()) {
    room.push_back({inverse(kTruth) * line.a, inverse(kTruth) * line.b});
    seen.push_back({inverse(moved) * room.back().a, inverse(moved) * room.back().b});
  }
  const auto mapOf = [](const std::vector<Segment>& segments) {
    return std::make_shared<const SurfaceMap>(Lattice(200, 200, 0.05, {-5.0, -5.0, 0.0}), segments);
  };
  const auto there = ScanMatcher(with("line"), mapOf(room)).match({}, scanAt(moved, room));
  const auto back = ScanMatcher(with("line"), mapOf(seen)).match({}, scanAt({}, room));
  EXPECT_THAT(there.T_map_base, PoseNear(moved, 1e-6, 1e-7));
  EXPECT_THAT(back.T_map_base, PoseNear(inverse(there.T_map_base), 1e-6, 2e-7));
}

}  // namespace
}  // namespace adaptive_localization
