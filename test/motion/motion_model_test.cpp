// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/motion/motion_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "adaptive_localization/filters/builtins.hpp"
#include "core/parallel.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_parameters.hpp"

namespace adaptive_localization {
namespace {

struct ModelOptions : MotionOptions {
  std::string odom_model_type;
};

std::unique_ptr<MotionModel> makeModel(const ModelOptions& options) {
  return builtins().motions.make(options.odom_model_type, parametersOf<MotionOptions>(options));
}

ModelOptions modelOptions(const std::string& type, double alpha) {
  ModelOptions options;
  options.odom_model_type = type;
  options.odom_alpha1 = options.odom_alpha2 = options.odom_alpha3 = alpha;
  options.odom_alpha4 = options.odom_alpha5 = alpha;
  options.odom_noise_xy = options.odom_noise_theta = 0.0;
  return options;
}

Particles moved(const ModelOptions& options, const Pose2& motion, Eigen::Index count,
                const Pose2& from = {}, std::uint64_t seed = 1) {
  Particles particles(count);
  particles.x.setConstant(from.x);
  particles.y.setConstant(from.y);
  particles.theta.setConstant(from.theta);
  Rng rng(seed);
  makeModel(options)->propagate(motion, particles, rng);
  return particles;
}

Eigen::Matrix3d sampleCovariance(const Particles& particles, const Pose2& mean) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    const Eigen::Vector3d d(particles.x[i] - mean.x, particles.y[i] - mean.y,
                            wrapAngle(particles.theta[i] - mean.theta));
    covariance += d * d.transpose() / static_cast<double>(particles.size());
  }
  return covariance;
}

class EveryModel : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Motion, EveryModel,
                         testing::Values("diff", "omni", "diff-corrected", "omni-corrected"));

const Pose2 kMotions[] = {{0.3, 0.0, 0.0},  {0.3, 0.1, 0.4},    {-0.3, 0.05, -0.2},
                          {0.0, 0.0, 0.7},  {0.002, 0.0, 0.0},  {-0.004, 0.001, 0.01},
                          {0.0, 0.25, 0.0}, {-0.1, -0.3, 0.03}, {0.0, 0.003, -0.02}};

TEST_P(EveryModel, MovesExactlyAsOdometrySaysWithoutNoise) {
  Rng rng(1);
  for (const Pose2& motion : kMotions) {
    const Pose2 from = randomPose(rng, 10.0);
    const Particles particles = moved(modelOptions(GetParam(), 0.0), motion, 1, from);
    EXPECT_THAT(particles.pose(0), PoseNear(from * motion, 1e-12, 1e-12))
        << testing::PrintToString(motion);
  }
}

TEST_P(EveryModel, StaysWhereItIsWithoutMotion) {
  const Pose2 from{1.0, 2.0, 3.0};
  const Particles particles = moved(modelOptions(GetParam(), 0.5), {}, 100, from);
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    ASSERT_THAT(particles.pose(i), PoseNear(from, 1e-12, 1e-12));
  }
  EXPECT_EQ(makeModel(modelOptions(GetParam(), 0.5))->covariance({}).norm(), 0.0);
}

TEST_P(EveryModel, SamplesTheNoiseThatItsCovarianceTells) {
  for (const Pose2& motion : kMotions) {
    const ModelOptions options = modelOptions(GetParam(), 0.002);
    const Eigen::Matrix3d told = makeModel(options)->covariance(motion);
    const Eigen::Matrix3d sampled = sampleCovariance(moved(options, motion, 100000), motion);
    const double tolerance = 0.03 * told.diagonal().maxCoeff() + 1e-12;
    EXPECT_LT((sampled - told).cwiseAbs().maxCoeff(), tolerance)
        << testing::PrintToString(motion) << "\ntold\n"
        << told << "\nsampled\n"
        << sampled;
  }
}

TEST_P(EveryModel, TellsASymmetricPositiveCovariance) {
  Rng rng(2);
  for (int i = 0; i < 500; ++i) {
    const auto model = makeModel(modelOptions(GetParam(), 0.2));
    const Eigen::Matrix3d covariance = model->covariance(randomPose(rng, 1.0));
    ASSERT_TRUE(covariance.isApprox(covariance.transpose()));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    ASSERT_GE(solver.eigenvalues().minCoeff(), -1e-12);
  }
}

TEST_P(EveryModel, DrivesBackwardsInReverse) {
  for (const double metres : {0.001, 0.005, 0.02, 0.5}) {
    const Particles particles = moved(modelOptions(GetParam(), 0.01), {-metres, 0.0, 0.0}, 2000);
    EXPECT_NEAR(particles.x.mean(), -metres, 0.05 * metres);
    EXPECT_NEAR(particles.theta.mean(), 0.0, 0.01);
  }
}

TEST_P(EveryModel, KeepsHeadingsWrapped) {
  const Particles particles =
      moved(modelOptions(GetParam(), 0.9), {0.1, 0.0, 0.5}, 5000, {0.0, 0.0, kPi - 0.3});
  EXPECT_GT(particles.theta.minCoeff(), -kPi);
  EXPECT_LE(particles.theta.maxCoeff(), kPi);
  EXPECT_GT((particles.theta < 0.0).count(), 100);
  EXPECT_GT((particles.theta > 0.0).count(), 100);
}

TEST_P(EveryModel, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto run = [&](int threads) {
    setThreads(threads);
    const Particles particles = moved(modelOptions(GetParam(), 0.2), {0.3, 0.1, 0.2}, 5000);
    setThreads(1);
    return particles;
  };
  const Particles one = run(1), two = run(2), four = run(4);
  for (const auto* other : {&two, &four}) {
    EXPECT_TRUE((one.x == other->x).all() && (one.y == other->y).all() &&
                (one.theta == other->theta).all());
  }
}

TEST_P(EveryModel, AddsTheConstantNoiseWhateverTheMotion) {
  ModelOptions options = modelOptions(GetParam(), 0.0);
  options.odom_noise_xy = 0.02;
  options.odom_noise_theta = 0.03;
  const Eigen::Matrix3d sampled = sampleCovariance(moved(options, {}, 100000), {});
  EXPECT_NEAR(std::sqrt(sampled(0, 0)), 0.02, 3e-4);
  EXPECT_NEAR(std::sqrt(sampled(1, 1)), 0.02, 3e-4);
  EXPECT_NEAR(std::sqrt(sampled(2, 2)), 0.03, 5e-4);
  EXPECT_TRUE(makeModel(options)->covariance({}).isApprox(
      Eigen::Vector3d(4e-4, 4e-4, 9e-4).asDiagonal().toDenseMatrix()));
}

/// Standard deviations along and across a straight course and in heading, of a motion ahead.
Eigen::Vector3d deviations(const ModelOptions& options, const Pose2& motion) {
  return makeModel(options)->covariance(motion).diagonal().cwiseSqrt();
}

ModelOptions distinctAlphas(const std::string& type) {
  ModelOptions options = modelOptions(type, 0.0);
  options.odom_alpha1 = 0.11;
  options.odom_alpha2 = 0.22;
  options.odom_alpha3 = 0.33;
  options.odom_alpha4 = 0.44;
  options.odom_alpha5 = 0.55;
  return options;
}

TEST(DifferentialDrive, HasAmclsFormulas) {
  const double d = 0.4, turn = 0.3;
  // straight ahead: rot1 = rot2 = 0
  const Eigen::Vector3d corrected = deviations(distinctAlphas("diff-corrected"), {d, 0.0, 0.0});
  EXPECT_NEAR(corrected[0], std::sqrt(0.33) * d, 1e-12);
  EXPECT_NEAR(corrected[1], d * std::sqrt(0.22) * d, 1e-12);
  EXPECT_NEAR(corrected[2], std::sqrt(2.0 * 0.22) * d, 1e-12);
  const Eigen::Vector3d plain = deviations(distinctAlphas("diff"), {d, 0.0, 0.0});
  EXPECT_NEAR(plain[0], 0.33 * d * d, 1e-12);
  EXPECT_NEAR(plain[1], d * 0.22 * d * d, 1e-12);
  EXPECT_NEAR(plain[2], std::sqrt(2.0) * 0.22 * d * d, 1e-12);
  // on the spot: all of it is rot2
  const Eigen::Vector3d turned = deviations(distinctAlphas("diff-corrected"), {0.0, 0.0, turn});
  EXPECT_NEAR(turned[0], std::sqrt(0.44) * turn, 1e-12);
  EXPECT_NEAR(turned[2], std::sqrt(0.11) * turn, 1e-12);
  const Eigen::Vector3d plain_turned = deviations(distinctAlphas("diff"), {0.0, 0.0, turn});
  EXPECT_NEAR(plain_turned[0], 0.44 * turn * turn, 1e-12);
  EXPECT_NEAR(plain_turned[2], 0.11 * turn * turn, 1e-12);
}

TEST(OmniDrive, HasAmclsFormulas) {
  const double d = 0.4, turn = 0.3;
  const double d2 = d * d, turn2 = turn * turn;
  const Eigen::Vector3d corrected = deviations(distinctAlphas("omni-corrected"), {d, 0.0, turn});
  EXPECT_NEAR(corrected[0], std::sqrt(0.33 * d2 + 0.44 * turn2), 1e-12);
  EXPECT_NEAR(corrected[1], std::sqrt(0.55 * d2 + 0.44 * turn2), 1e-12);
  EXPECT_NEAR(corrected[2], std::sqrt(0.11 * turn2 + 0.22 * d2), 1e-12);
  const Eigen::Vector3d plain = deviations(distinctAlphas("omni"), {d, 0.0, turn});
  EXPECT_NEAR(plain[0], 0.33 * d2 + 0.11 * turn2, 1e-12);
  EXPECT_NEAR(plain[1], 0.55 * d2 + 0.11 * turn2, 1e-12);
  EXPECT_NEAR(plain[2], 0.44 * turn2 + 0.22 * d2, 1e-12);
}

TEST(DifferentialDrive, IsAsNoisyBackwardsAsForwards) {
  const ModelOptions options = distinctAlphas("diff-corrected");
  for (const double metres : {0.003, 0.3}) {
    EXPECT_TRUE(deviations(options, {metres, 0.0, 0.1})
                    .isApprox(deviations(options, {-metres, 0.0, 0.1}), 1e-9));
  }
}

TEST(DifferentialDrive, DoesNotTakeTheCourseOfATinyMotionForARotation) {
  const Eigen::Vector3d ahead = deviations(distinctAlphas("diff-corrected"), {0.001, 0.0, 0.0});
  const Eigen::Vector3d aside = deviations(distinctAlphas("diff-corrected"), {0.0, 0.001, 0.0});
  EXPECT_NEAR(aside[2], ahead[2], 1e-9);
}

}  // namespace
}  // namespace adaptive_localization
