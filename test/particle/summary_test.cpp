// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/particle/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

void addCloud(Particles& particles, Eigen::Index begin, Eigen::Index end, const Pose2& mean,
              double metres, double radians, Rng& rng) {
  for (Eigen::Index i = begin; i < end; ++i) {
    particles.setPose(i, {rng.normal(mean.x, metres), rng.normal(mean.y, metres),
                          wrapAngle(rng.normal(mean.theta, radians))});
  }
}

Eigen::ArrayXd equalWeights(Eigen::Index count) {
  return Eigen::ArrayXd::Constant(count, 1.0 / static_cast<double>(count));
}

TEST(Summarize, AveragesHeadingsThatStraddlePi) {
  Rng rng(1);
  Particles particles(4000);
  addCloud(particles, 0, 4000, {1.0, 2.0, kPi}, 0.05, 0.1, rng);
  const Estimate estimate = summarize(particles, equalWeights(4000));
  EXPECT_THAT(estimate.T_map_base, PoseNear(Pose2{1.0, 2.0, kPi}, 0.01, 0.01));
  EXPECT_NEAR(std::sqrt(estimate.covariance(2, 2)), 0.1, 0.005);
  EXPECT_EQ(estimate.modes.size(), 1u);
  EXPECT_THAT(estimate, IsSaneEstimate());
}

TEST(Summarize, TellsTwoModesWithTheirMasses) {
  Rng rng(2);
  Particles particles(4000);
  addCloud(particles, 0, 1000, {1.25, 2.25, 0.1}, 0.05, 0.02, rng);
  addCloud(particles, 1000, 4000, {8.25, 3.25, -2.0}, 0.1, 0.03, rng);
  const Estimate estimate = summarize(particles, equalWeights(4000));
  ASSERT_EQ(estimate.modes.size(), 2u);
  EXPECT_NEAR(estimate.modes[0].mass, 0.75, 1e-9);
  EXPECT_NEAR(estimate.modes[1].mass, 0.25, 1e-9);
  EXPECT_THAT(estimate.modes[1].T_map_base, PoseNear(Pose2{1.25, 2.25, 0.1}, 0.01, 0.01));
  EXPECT_THAT(estimate, IsSaneEstimate());
}

TEST(Summarize, TakesPoseAndCovarianceFromTheSameCluster) {
  Rng rng(3);
  Particles particles(3000);
  addCloud(particles, 0, 1000, {1.25, 2.25, 0.1}, 0.05, 0.02, rng);
  addCloud(particles, 1000, 3000, {8.25, 3.25, -2.0}, 0.1, 0.03, rng);
  const Estimate estimate = summarize(particles, equalWeights(3000));
  EXPECT_THAT(estimate.T_map_base, PoseNear(Pose2{8.25, 3.25, -2.0}, 0.01, 0.01));
  EXPECT_NEAR(std::sqrt(estimate.covariance(0, 0)), 0.1, 0.006);
  EXPECT_NEAR(std::sqrt(estimate.covariance(2, 2)), 0.03, 0.002);
}

TEST(Summarize, GoesByWeightNotByNumber) {
  Rng rng(4);
  Particles particles(1100);
  addCloud(particles, 0, 100, {1.25, 2.25, 0.1}, 0.02, 0.02, rng);
  addCloud(particles, 100, 1100, {8.25, 3.25, -2.0}, 0.02, 0.02, rng);
  Eigen::ArrayXd weights(1100);
  weights << Eigen::ArrayXd::Constant(100, 0.9 / 100), Eigen::ArrayXd::Constant(1000, 0.1 / 1000);
  const Estimate estimate = summarize(particles, weights);
  EXPECT_THAT(estimate.T_map_base, PoseNear(Pose2{1.25, 2.25, 0.1}, 0.01, 0.01));
  EXPECT_NEAR(estimate.modes[0].mass, 0.9, 1e-9);
}

TEST(Summarize, ParticlesWithoutWeightDoNotMoveTheMean) {
  Particles particles(2);
  particles.setPose(0, {1.25, 1.25, 0.2});
  particles.setPose(1, {1.45, 1.25, 0.3});
  const Eigen::ArrayXd weights = Eigen::Array2d(1.0, 0.0);
  EXPECT_THAT(summarize(particles, weights).T_map_base,
              PoseNear(Pose2{1.25, 1.25, 0.2}, 1e-12, 1e-12));
}

TEST(Summarize, JoinsBinsAcrossTheSeamOfHeadings) {
  Particles particles(2);
  particles.setPose(0, {0.25, 0.25, 0.01});
  particles.setPose(1, {0.25, 0.25, -0.01});
  EXPECT_EQ(summarize(particles, equalWeights(2)).modes.size(), 1u);
}

TEST(Summarize, HasMassesThatSumToOneForAnyCloud) {
  Rng rng(5);
  for (const double side : {0.1, 3.0, 100.0}) {
    Particles particles(2000);
    Eigen::ArrayXd weights(2000);
    for (Eigen::Index i = 0; i < 2000; ++i) {
      particles.setPose(i, randomPose(rng, side));
      weights[i] = std::exp(rng.normal(0.0, 4.0));
    }
    weights[7] = 0.0;
    EXPECT_THAT(summarize(particles, weights / weights.sum()), IsSaneEstimate());
  }
}

TEST(Summarize, HasOneEmptyModeForNoParticles) {
  const Estimate estimate = summarize(Particles{}, Eigen::ArrayXd{});
  ASSERT_EQ(estimate.modes.size(), 1u);
  EXPECT_EQ(estimate.modes[0].mass, 0.0);
}

TEST(MeanAndCovariance, IsTheTextbooks) {
  Particles particles(3);
  particles.setPose(0, {0.0, 0.0, 0.1});
  particles.setPose(1, {1.0, 2.0, 0.3});
  particles.setPose(2, {9.0, 9.0, 9.0});
  const Mode mode = meanAndCovariance(particles, Eigen::Array3d(0.25, 0.75, 5.0), {0, 1});
  EXPECT_DOUBLE_EQ(mode.mass, 1.0);
  EXPECT_NEAR(mode.T_map_base.x, 0.75, 1e-12);
  EXPECT_NEAR(mode.T_map_base.theta, 0.25, 1e-3);
  EXPECT_NEAR(mode.covariance(0, 0), 0.1875, 1e-12);
  EXPECT_NEAR(mode.covariance(0, 1), 0.375, 1e-12);
}

}  // namespace
}  // namespace adaptive_localization
