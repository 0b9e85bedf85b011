// SPDX-License-Identifier: BSD-3-Clause
#include "core/gate.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace adaptive_localization {
namespace {

/// The distance that 1 % of poses exceed is that of 3.37 standard deviations.
TEST(Gate, IsSoManyStandardDeviationsWideAlongEachAxisAlone) {
  const Gaussian2 belief{{1.0, 2.0, 0.5}, Eigen::Vector3d(4.0, 1.0, 0.09).asDiagonal()};
  EXPECT_TRUE(isWithin(belief, {1.0 + 2.0 * 3.3, 2.0, 0.5}));
  EXPECT_FALSE(isWithin(belief, {1.0 + 2.0 * 3.4, 2.0, 0.5}));
  EXPECT_TRUE(isWithin(belief, {1.0, 2.0 - 3.3, 0.5}));
  EXPECT_FALSE(isWithin(belief, {1.0, 2.0 - 3.4, 0.5}));
  EXPECT_TRUE(isWithin(belief, {1.0, 2.0, 0.5 + 0.3 * 3.3}));
  EXPECT_FALSE(isWithin(belief, {1.0, 2.0, 0.5 + 0.3 * 3.5}));
}

TEST(Gate, TurnsAreMeasuredTheShortWayRound) {
  const Gaussian2 belief{{0.0, 0.0, kPi - 0.01}, 0.01 * Eigen::Matrix3d::Identity()};
  EXPECT_TRUE(isWithin(belief, {0.0, 0.0, -kPi + 0.01}));
}

TEST(Gate, APoseThatIsKnownForSureIsMeantAFewCentimetresOff) {
  const Gaussian2 belief;
  EXPECT_TRUE(isWithin(belief, {0.1, 0.1, 0.0}));
  EXPECT_FALSE(isWithin(belief, {0.2, 0.0, 0.0}));
}

TEST(Gate, NothingIsWithinABeliefThatIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isWithin({{none, 0.0, 0.0}, Eigen::Matrix3d::Identity()}, {}));
  EXPECT_FALSE(isWithin({{}, none * Eigen::Matrix3d::Identity()}, {}));
}

}  // namespace
}  // namespace adaptive_localization
