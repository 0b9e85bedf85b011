// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/match/pose_kalman.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "adaptive_localization/particle/summary.hpp"
#include "observation/heading_prior.hpp"
#include "particle/gaussian_cloud.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

Eigen::Matrix3d diagonal(double xy, double theta) {
  return Eigen::Vector3d(xy, xy, theta).asDiagonal();
}

/// x' = x (+) (u + e), as a vector.
Eigen::Vector3d moved(const Pose2& x, const Pose2& u, const Eigen::Vector3d& e) {
  const Pose2 to = x * Pose2{u.x + e.x(), u.y + e.y(), u.theta + e.z()};
  return {to.x, to.y, to.theta};
}

/// By central differences.
template <class Function>
Eigen::Matrix3d jacobian(const Function& function) {
  constexpr double kStep = 1e-5;
  Eigen::Matrix3d J;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    Eigen::Vector3d slope = function(step) - function(-step);
    slope.z() = wrapAngle(slope.z());
    J.col(i) = slope / (2.0 * kStep);
  }
  return J;
}

Eigen::Matrix3d randomCovariance(Rng& rng) {
  Eigen::Matrix3d root;
  for (int i = 0; i < 9; ++i) root(i) = rng.normal();
  return root * root.transpose();
}

/// Sees two things, but one alone from beyond x = 1.
class Nearsighted : public ObservationModel {
 public:
  double score(const Observations&, const Particles&, Eigen::Ref<Eigen::ArrayXd>) const override {
    return 0.0;
  }

  std::vector<PoseObservation> linearized(const Observations&, const Pose2& pose) const override {
    PoseObservation seen;
    seen.innovation.setConstant(1, 2.0 - pose.x);
    seen.H = Eigen::RowVector3d::UnitX();
    seen.R.setConstant(1, 1, 0.01);
    return std::vector<PoseObservation>(pose.x > 1.0 ? 1 : 2, seen);
  }
};

TEST(PoseKalman, IsCorrectedByASenseThatSeesLessFromWhereItIsMovedTo) {
  PoseKalman kalman;
  kalman.reset({{0.0, 0.0, 0.0}, diagonal(1.0, 0.1)});
  correctBy(Nearsighted(), {}, kalman);
  EXPECT_NEAR(kalman.mean().x, 2.0, 0.05);
}

TEST(PoseKalman, PredictsWhatACloudOfSamplesDoes) {
  const Gaussian2 start{{1.0, 2.0, 0.7}, Eigen::Vector3d(0.01, 0.02, 0.003).asDiagonal()};
  const Pose2 motion{0.8, 0.1, 0.3};
  const Eigen::Matrix3d noise = Eigen::Vector3d(0.004, 0.001, 0.002).asDiagonal();
  PoseKalman kalman;
  kalman.reset(start);
  kalman.predict(motion, noise);
  Rng rng(5);
  constexpr Eigen::Index kCount = 100000;
  Particles cloud = drawCloud(start, kCount, rng);
  const Particles steps = drawCloud({motion, Eigen::Matrix3d::Zero()}, kCount, rng);
  const Particles errors = drawCloud({{}, noise}, kCount, rng);
  for (Eigen::Index i = 0; i < kCount; ++i) {
    const Pose2 step = steps.pose(i);
    const Pose2 error = errors.pose(i);
    cloud.setPose(
        i, cloud.pose(i) * Pose2{step.x + error.x, step.y + error.y, step.theta + error.theta});
  }
  EXPECT_THAT(kalman.mean(), PoseNear(start.mean * motion, 1e-12, 1e-12));
  Eigen::Matrix3d sampled = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < kCount; ++i) {
    const Pose2 pose = cloud.pose(i);
    const Eigen::Vector3d off(pose.x - kalman.mean().x, pose.y - kalman.mean().y,
                              wrapAngle(pose.theta - kalman.mean().theta));
    sampled += off * off.transpose() / static_cast<double>(kCount);
  }
  EXPECT_LT((sampled - kalman.covariance()).norm(), 0.02 * sampled.norm());
}

TEST(PoseKalman, PredictsWithTheJacobiansOfTheMotion) {
  Rng rng(8);
  for (int k = 0; k < 200; ++k) {
    const Gaussian2 belief{randomPose(rng, 10.0), randomCovariance(rng)};
    const Pose2 motion = randomPose(rng, 2.0);
    const Eigen::Matrix3d noise = randomCovariance(rng);
    PoseKalman kalman;
    kalman.reset(belief);
    kalman.predict(motion, noise);
    const Eigen::Matrix3d F = jacobian([&](const Eigen::Vector3d& e) {
      const Pose2& x = belief.mean;
      return moved({x.x + e.x(), x.y + e.y(), x.theta + e.z()}, motion, Eigen::Vector3d::Zero());
    });
    const Eigen::Matrix3d G =
        jacobian([&](const Eigen::Vector3d& e) { return moved(belief.mean, motion, e); });
    const Eigen::Matrix3d expected =
        F * belief.covariance * F.transpose() + G * noise * G.transpose();
    ASSERT_LT((kalman.covariance() - expected).norm(), 1e-8 * expected.norm()) << k;
    ASSERT_THAT(kalman.mean(), PoseNear(belief.mean * motion, 1e-12, 1e-12)) << k;
  }
}

/// Experiment E20: without observations the ellipse grows all the time; a wall on the right
/// corrects the distance from it and the heading, and nothing along it.
TEST(PoseKalman, DriftsUntilAWallTellsOfTheDirectionAcrossIt) {
  PoseKalman kalman;
  kalman.reset({{0.0, 0.0, 0.0}, diagonal(1e-4, 1e-5)});
  double area = 0.0;
  for (int k = 0; k < 100; ++k) {
    kalman.predict({0.1, 0.0, 0.0}, diagonal(1e-4, 1e-5));
    const double now = kalman.covariance().topLeftCorner<2, 2>().determinant();
    ASSERT_GT(now, area);
    area = now;
  }
  const double along = kalman.covariance()(0, 0);
  PoseObservation wall;
  wall.H.resize(2, 3);
  wall.H << 0.0, 1.0, 0.0, 0.0, 0.0, 1.0;
  wall.innovation = Eigen::Vector2d(0.3, 0.02);
  wall.R = Eigen::Vector2d(1e-4, 1e-5).asDiagonal();
  ASSERT_TRUE(kalman.correct(wall));
  EXPECT_NEAR(kalman.mean().y, 0.3, 0.01);
  EXPECT_NEAR(kalman.mean().x, 10.0, 1e-9);
  EXPECT_NEAR(kalman.covariance()(0, 0), along, 1e-9);
  EXPECT_LT(kalman.covariance()(1, 1), 1.1e-4);
}

TEST(PoseKalman, WrapsHeadings) {
  PoseKalman kalman;
  kalman.reset({{0.0, 0.0, kPi - 0.01}, diagonal(0.01, 0.01)});
  Match match;
  match.T_map_base = {0.0, 0.0, -kPi + 0.01};
  match.H = Eigen::Matrix3d::Identity();
  match.variance = Eigen::Vector3d(0.01, 0.01, 0.01);
  match.rest = Eigen::Vector3d::Zero();
  ASSERT_TRUE(kalman.correct(observationOf(kalman.mean(), match)));
  EXPECT_NEAR(std::abs(kalman.mean().theta), kPi, 1e-9);
}

TEST(PoseKalman, StaysSymmetricAndPositiveForAMillionSteps) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  PoseKalman kalman;
  kalman.reset({{0.0, 0.0, 0.0}, diagonal(0.01, 0.01)});
  Rng rng(3);
  for (int k = 0; k < 1000000; ++k) {
    kalman.predict({rng.uniform(-0.1, 0.1), 0.0, rng.uniform(-0.2, 0.2)}, diagonal(1e-6, 1e-7));
    PoseObservation seen;
    const auto rows = static_cast<Eigen::Index>(rng.below(4));
    seen.H.setZero(rows, 3);
    seen.R.setZero(rows, rows);
    seen.innovation.setZero(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (int j = 0; j < 3; ++j) seen.H(i, j) = rng.uniform(-1.0, 1.0);
      seen.R(i, i) = std::pow(10.0, rng.uniform(-9.0, 2.0));
      seen.innovation[i] = rng.normal(0.0, 0.01);
    }
    kalman.correct(seen);
    const Eigen::Matrix3d& P = kalman.covariance();
    ASSERT_EQ(P, P.transpose()) << k;
    solver.computeDirect(P, Eigen::EigenvaluesOnly);
    ASSERT_GT(solver.eigenvalues()[0], 1e-10) << k;  // variances of 1e-9 are seen
    ASSERT_TRUE(isFinite(kalman.mean())) << k;
  }
}

TEST(PoseKalman, RefusesAnObservationThatTellsNothingCertain) {
  PoseKalman kalman;
  kalman.reset({{1.0, 1.0, 0.0}, Eigen::Matrix3d::Zero()});
  PoseObservation seen;
  seen.H = Eigen::Matrix3d::Identity();
  seen.R = Eigen::Matrix3d::Zero();
  seen.innovation = Eigen::Vector3d(1.0, 1.0, 0.0);
  EXPECT_FALSE(kalman.correct(seen));
  EXPECT_TRUE(std::isinf(kalman.distanceOf(seen)));
  EXPECT_DOUBLE_EQ(kalman.mean().x, 1.0);
}

/// A compass that says so.
Observations heading(double theta, double deviation) {
  Observations observations;
  observations.heading = Heading{theta, deviation};
  return observations;
}

TEST(PoseKalman, IsCorrectedByOtherSenses) {
  PoseKalman kalman;
  kalman.reset({{1.0, 1.0, 0.0}, diagonal(0.01, 0.04)});
  correctBy(HeadingPrior(), heading(0.2, 0.2), kalman);
  EXPECT_NEAR(kalman.mean().theta, 0.1, 1e-12);  // as sure as the belief
  EXPECT_NEAR(kalman.covariance()(2, 2), 0.02, 1e-12);
  EXPECT_DOUBLE_EQ(kalman.mean().x, 1.0);
}

/// 99.9 % of a chi-square variable with 1 and with 3 degrees of freedom: 10.8 and 16.3.
TEST(PoseKalman, AnOutlierIsFartherOffTheMoreDirectionsAreSeen) {
  PoseKalman belief;
  belief.reset({{1.0, 1.0, 0.0}, diagonal(0.5, 0.5)});
  const auto off = [](Eigen::Index directions, double metres) {
    PoseObservation seen;
    seen.innovation = metres * PoseObservation::Vector::Unit(directions, 0);
    seen.H = PoseObservation::Rows::Identity(directions, 3);
    seen.R = 0.5 * PoseObservation::Square::Identity(directions, directions);
    return seen;
  };
  EXPECT_FALSE(isOutlier(off(1, 3.2), belief));
  EXPECT_TRUE(isOutlier(off(1, 3.4), belief));
  EXPECT_FALSE(isOutlier(off(3, 4.0), belief));
  EXPECT_TRUE(isOutlier(off(3, 4.1), belief));
}

TEST(PoseKalman, IsNotCorrectedByOutliersButTellsThem) {
  const Gaussian2 belief{{1.0, 1.0, 0.0}, diagonal(0.01, 0.01)};
  PoseKalman kalman;
  kalman.reset(belief);
  correctBy(HeadingPrior(), heading(1.0, 0.1), kalman);
  EXPECT_DOUBLE_EQ(kalman.mean().theta, 0.0);
  EXPECT_TRUE(areContradicting(HeadingPrior(), heading(1.0, 0.1), belief));
  EXPECT_FALSE(areContradicting(HeadingPrior(), heading(0.2, 0.1), belief));
  EXPECT_FALSE(areContradicting(HeadingPrior(), {}, belief));
}

}  // namespace
}  // namespace adaptive_localization
