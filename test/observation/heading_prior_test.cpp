// SPDX-License-Identifier: BSD-3-Clause
#include "observation/heading_prior.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace adaptive_localization {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

Observations told(double theta, double deviation) {
  Observations observations;
  observations.heading = Heading{theta, deviation};
  return observations;
}

double scoreAt(double theta, const Observations& observations) {
  Particles one(1);
  one.setPose(0, {3.0, -2.0, theta});
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Constant(1, 5.0);  // it adds
  HeadingPrior().score(observations, one, log_likelihood);
  return log_likelihood[0] - 5.0;
}

TEST(HeadingPrior, FollowsItsEquation) {
  EXPECT_NEAR(scoreAt(0.5, told(0.5, 0.1)), 0.0, 1e-12);
  EXPECT_NEAR(scoreAt(0.7, told(0.5, 0.1)), std::log(0.9 * std::exp(-2.0) + 0.1), 1e-12);
}

TEST(HeadingPrior, KnowsThatAnglesAreRound) {
  EXPECT_NEAR(scoreAt(-3.1, told(3.1, 0.1)), scoreAt(0.0, told(2.0 * kPi - 6.2, 0.1)), 1e-9);
}

TEST(HeadingPrior, NeverRulesAnythingOut) {
  EXPECT_NEAR(scoreAt(0.0, told(kPi, 0.01)), std::log(0.1), 1e-9);
}

TEST(HeadingPrior, SaysNothingWithoutAHeadingOrOfNonsense) {
  for (const Observations& nothing :
       {Observations{}, told(std::nan(""), 0.1), told(0.0, std::nan("")), told(0.0, -1.0)}) {
    Particles one(1);
    Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(1);
    EXPECT_EQ(HeadingPrior().score(nothing, one, log_likelihood), 0.0);
    EXPECT_EQ(log_likelihood[0], 0.0);
    EXPECT_THAT(HeadingPrior().linearized(nothing, {}), IsEmpty());
  }
}

TEST(HeadingPrior, IsALinearObservationOfTheta) {
  const auto seen = HeadingPrior().linearized(told(-3.0, 0.2), {1.0, 2.0, 3.0});
  ASSERT_THAT(seen, SizeIs(1));
  ASSERT_EQ(seen[0].innovation.size(), 1);
  EXPECT_NEAR(seen[0].innovation[0], 2.0 * kPi - 6.0, 1e-9);
  EXPECT_EQ(seen[0].H, Eigen::RowVector3d(0.0, 0.0, 1.0));
  EXPECT_NEAR(seen[0].R(0, 0), 0.04, 1e-12);
}

}  // namespace
}  // namespace adaptive_localization
