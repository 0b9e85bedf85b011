// SPDX-License-Identifier: BSD-3-Clause
#include "particle/gaussian_cloud.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "adaptive_localization/particle/summary.hpp"

namespace adaptive_localization {
namespace {

Eigen::Matrix3d tilted() {
  Eigen::Matrix3d covariance;
  covariance << 0.04, 0.01, 0.002, 0.01, 0.02, -0.001, 0.002, -0.001, 0.005;
  return covariance;
}

TEST(GaussianCloud, TheRootSquaredIsTheCovariance) {
  const Eigen::Matrix3d root = squareRoot(tilted());
  EXPECT_LT((root * root.transpose() - tilted()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(GaussianCloud, WhatIsNegativeOrNotFiniteIsNoSpread) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.diagonal() << 0.04, -1.0, 0.0;
  const Eigen::Matrix3d root = squareRoot(covariance);
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  expected(0, 0) = 0.04;
  EXPECT_LT((root * root.transpose() - expected).cwiseAbs().maxCoeff(), 1e-12);
  covariance(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(squareRoot(covariance), Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
}

TEST(GaussianCloud, HasTheMeanAndTheCovarianceThatItIsDrawnFrom) {
  Rng rng(3);
  const Pose2 mean{1.0, -2.0, 3.1};  // straddles pi
  const Particles cloud = drawCloud({mean, tilted()}, 20000, rng);
  ASSERT_EQ(cloud.size(), 20000);
  std::vector<Eigen::Index> all(20000);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Eigen::Index>(i);
  const Mode mode = meanAndCovariance(cloud, Eigen::ArrayXd::Constant(20000, 1.0 / 20000), all);
  EXPECT_LT(distance(mode.T_map_base, mean), 0.005);
  EXPECT_NEAR(wrapAngle(mode.T_map_base.theta - mean.theta), 0.0, 0.002);
  EXPECT_LT((mode.covariance - tilted()).cwiseAbs().maxCoeff(), 0.001);
}

}  // namespace
}  // namespace adaptive_localization
