// SPDX-License-Identifier: BSD-3-Clause
#include "eval/consistency.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <limits>
#include <stdexcept>

#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {
namespace {

TEST(Consistency, NormalisesErrorsByTheirCovariance) {
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.04, 0.01, 0.25).asDiagonal();
  const auto error = normalizedError({1.0, 2.0, 0.5}, covariance, {1.2, 1.9, 1.0});
  ASSERT_TRUE(error);
  EXPECT_NEAR(*error, 1.0 + 1.0 + 1.0, 1e-12);
}

TEST(Consistency, KnowsThatHeadingsWrap) {
  const Eigen::Matrix3d covariance = Eigen::Vector3d(1.0, 1.0, 0.01).asDiagonal();
  const auto error = normalizedError({0.0, 0.0, kPi - 0.05}, covariance, {0.0, 0.0, -kPi + 0.05});
  ASSERT_TRUE(error);
  EXPECT_NEAR(*error, 1.0, 1e-9);
}

TEST(Consistency, HasNoNormalisedErrorWithoutACovariance) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  EXPECT_FALSE(normalizedError({}, covariance, {}));
  covariance = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();
  EXPECT_FALSE(normalizedError({}, covariance, {}));
  covariance(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(normalizedError({}, covariance, {}));
}

// Chi-square quantiles for 3, 30 and 300 degrees of freedom: Abramowitz and Stegun, table 26.8, and
// R's qchisq.
TEST(Consistency, HasTheBandsOfTheTables) {
  EXPECT_NEAR(consistencyBand(1).low, 0.2158, 1e-4);
  EXPECT_NEAR(consistencyBand(1).high, 9.3484, 1e-4);
  EXPECT_NEAR(consistencyBand(10).low, 16.7908 / 10.0, 1e-5);
  EXPECT_NEAR(consistencyBand(10).high, 46.9792 / 10.0, 1e-5);
  EXPECT_NEAR(consistencyBand(100).low, 253.912 / 100.0, 1e-4);
  EXPECT_NEAR(consistencyBand(100).high, 349.874 / 100.0, 1e-4);
  EXPECT_NEAR(consistencyBand(1, 0.98).high, 11.3449, 1e-4) << "the gate of 99 per cent";
}

TEST(Consistency, HasNoBandOfNothing) {
  EXPECT_THROW(consistencyBand(0), std::invalid_argument);
  EXPECT_THROW(consistencyBand(10, 1.0), std::invalid_argument);
  EXPECT_THROW(consistencyBand(10, std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
}

/// The average over runs of errors drawn from a Gaussian, judged by another.
double averageError(const Eigen::Matrix3d& true_covariance, const Eigen::Matrix3d& claimed,
                    int runs) {
  Rng rng(1);
  const Eigen::Matrix3d root = true_covariance.llt().matrixL();
  double sum = 0.0;
  for (int i = 0; i < runs; ++i) {
    const Eigen::Vector3d error =
        root * Eigen::Vector3d(rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1));
    sum += normalizedError({}, claimed, {error.x(), error.y(), error.z()}).value();
  }
  return sum / runs;
}

TEST(Consistency, HoldsGaussiansForConsistentAndNoOthers) {
  Eigen::Matrix3d covariance;
  covariance << 4e-4, 1e-4, 2e-5, 1e-4, 1e-4, -1e-5, 2e-5, -1e-5, 1e-5;
  const Band band = consistencyBand(400);
  EXPECT_TRUE(band.contains(averageError(covariance, covariance, 400)));
  EXPECT_GT(averageError(covariance, covariance / 1.3, 400), band.high);
  EXPECT_LT(averageError(covariance, covariance * 1.3, 400), band.low);
}

}  // namespace
}  // namespace adaptive_localization
