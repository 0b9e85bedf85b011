// SPDX-License-Identifier: BSD-3-Clause
// What a match tells a Kalman filter: with a prior or without, the posterior is the same one.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "../../src/match/pose_kalman.hpp"
#include "scan_toys.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

Eigen::Matrix3d diagonal(double x, double y, double theta) {
  return Eigen::Vector3d(x, y, theta).asDiagonal();
}

/// The belief after a match from it, told of the prior or not.
Gaussian2 corrected(const Gaussian2& belief, const ScanMatcher& matcher, const Scan& scan,
                    bool tells_prior) {
  PoseKalman kalman;
  kalman.reset(belief);
  const Eigen::Matrix3d information = belief.covariance.inverse();
  const Match match = tells_prior ? matcher.match(belief.mean, scan, information)
                                  : matcher.match(belief.mean, scan);
  EXPECT_TRUE(match.isGood()) << toText(match.fault);
  EXPECT_TRUE(kalman.correct(observationOf(kalman.mean(), match)));
  return kalman.belief();
}

double largestRest(const Gaussian2& belief, const ScanMatcher& matcher, const Scan& scan) {
  const Match match = matcher.match(belief.mean, scan, belief.covariance.inverse());
  return match.rest.cwiseAbs().maxCoeff();
}

TEST(ScanMatcherPrior, GivesThePosteriorThatAMatchWithoutItGives) {
  MatchOptions options = with("line", "none");
  options.match_information = 0.02;  // as unsure as the prior
  const ScanMatcher matcher(options, surfacesOf(roomLines()));
  Rng rng(17);
  double rest = 0.0, apart = 0.0, turned = 0.0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Scan scan = scanAt(kTruth, roomLines(), 0.01, seed);
    const Gaussian2 belief{
        kTruth * Pose2{rng.normal(0.0, 0.03), rng.normal(0.0, 0.03), rng.normal(0.0, 0.02)},
        diagonal(0.0009, 0.0009, 0.0004)};
    const Gaussian2 with_prior = corrected(belief, matcher, scan, true);
    const Gaussian2 without = corrected(belief, matcher, scan, false);
    rest = std::max(rest, largestRest(belief, matcher, scan));
    apart = std::max(apart, distance(with_prior.mean, without.mean));
    turned = std::max(turned, std::abs(wrapAngle(with_prior.mean.theta - without.mean.theta)));
    EXPECT_LT((with_prior.covariance - without.covariance).norm(),
              0.03 * without.covariance.norm());
  }
  EXPECT_GT(rest, 0.05);
  EXPECT_LT(apart, 0.001);
  EXPECT_LT(turned, 0.001);
}

TEST(ScanMatcherPrior, MakesNoDifferenceToPoints) {
  const ScanMatcher matcher(with("point", "none"), surfacesOf(roomLines()));
  const Scan scan = scanAt(kTruth, roomLines(), 0.01);
  const Pose2 guess = kTruth * Pose2{0.05, -0.03, 0.02};
  const Match free = matcher.match(guess, scan);
  const Match held = matcher.match(guess, scan, diagonal(1e6, 1e6, 1e6));
  EXPECT_THAT(held.T_map_base, PoseNear(free.T_map_base, 0.0, 0.0));
  EXPECT_GT(distance(held.T_map_base, guess), 0.04);
  ASSERT_EQ(held.H.rows(), 3);
  EXPECT_TRUE(held.rest.isZero(0.0)) << "an observation of where the points were brought";
  EXPECT_TRUE(free.rest.isZero(0.0));
}

TEST(ScanMatcherPrior, OfSomeDirectionsOnlyIsEnough) {
  const auto surfaces = std::make_shared<const SurfaceMap>(
      Lattice(400, 60, 0.05, {-10.0, -0.5, 0.0}), corridorLines());
  const ScanMatcher matcher(with("line"), surfaces);
  const Pose2 truth{0.0, 1.1, 0.1}, guess{0.3, 1.05, 0.08};
  const Scan scan = scanAt(truth, corridorLines(), 0.01, 3);
  for (const Eigen::Matrix3d& prior :
       {diagonal(0, 0, 100), diagonal(0, 100, 0), diagonal(0, 100, 100), diagonal(100, 100, 0),
        diagonal(-1e-9, 100, 100)}) {
    const Match match = matcher.match(guess, scan, prior);
    ASSERT_TRUE(match.isGood()) << prior;
    EXPECT_THAT(match.T_map_base, PoseNear(Pose2{guess.x, truth.y, truth.theta}, 0.005, 0.003))
        << prior;
  }
}

TEST(ScanMatcherPrior, ThatIsNoneLeavesThePoseAsItWasGuessed) {
  const ScanMatcher matcher(with("line"), surfacesOf(roomLines()));
  const Scan scan = scanAt(kTruth, roomLines());
  const Pose2 guess = kTruth * Pose2{0.02, 0.0, 0.0};
  for (const double odd : {std::nan(""), -1e9, std::numeric_limits<double>::infinity()}) {
    const Match match = matcher.match(guess, scan, diagonal(odd, odd, odd));
    EXPECT_THAT(match.T_map_base, PoseNear(guess, 0.0, 0.0)) << odd;
    EXPECT_TRUE(match.H.allFinite() && match.rest.allFinite()) << odd;
  }
}

/// What all hits share adds to the covariance of the pose as it is, whichever rows say so.
TEST(ScanMatcherPrior, RowsDoNotDependOnEachOther) {
  MatchOptions options = with("line");
  const Scan scan = scanAt(kTruth, roomLines(), 0.01);
  const Match exact = ScanMatcher(options, surfacesOf(roomLines())).match(kTruth, scan);
  options.match_map_std = 0.05;
  options.match_map_turn_std = 0.003;
  const Match drawn = ScanMatcher(options, surfacesOf(roomLines())).match(kTruth, scan);
  ASSERT_EQ(drawn.H.rows(), 3);
  const Eigen::Matrix3d expected =
      exact.information().inverse() + diagonal(0.0025, 0.0025, 0.000009);
  const Eigen::Matrix3d covariance = drawn.information().inverse();
  EXPECT_LT((covariance - expected).norm(), 1e-9 * expected.norm());
  EXPECT_GT(drawn.variance.minCoeff(), 0.0);
}

}  // namespace
}  // namespace adaptive_localization
