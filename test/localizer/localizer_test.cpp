// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/localizer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/pose_matchers.hpp"
#include "support/toy_parameters.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

Gaussian2 roughly(const Pose2& mean) {
  return {mean, Eigen::Vector3d(0.01, 0.01, 0.005).asDiagonal()};
}

class TrackingLocalizer : public testing::Test {
 protected:
  TrackingLocalizer() : localizer_(parametersWith(), map_) { localizer_.reset(roughly(start_)); }

  /// The answer for a robot that is where odometry says, up to the frame.
  Localization at(const Pose2& T_odom_base) {
    return localizer_.update(T_odom_base, laser_.observe(map_, start_ * T_odom_base));
  }

  std::shared_ptr<const OccupancyGrid> map_ = asymmetricWorld();
  ToyLaser laser_{61, -2.0, 2.0, 12.0};
  Pose2 start_{1.0, 1.0, 0.0};
  Localizer localizer_;
};

TEST_F(TrackingLocalizer, UpdatesAtOnceAndThenByDistance) {
  EXPECT_TRUE(at({}).updated);
  EXPECT_FALSE(at({0.1, 0.0, 0.0}).updated);
  EXPECT_FALSE(at({0.19, 0.0, 0.0}).updated);
  EXPECT_TRUE(at({0.21, 0.0, 0.0}).updated);
  EXPECT_FALSE(at({0.40, 0.0, 0.0}).updated);  // counted from the last update
  EXPECT_TRUE(at({0.42, 0.0, 0.0}).updated);
}

TEST_F(TrackingLocalizer, UpdatesByAngleTheShortWayRound) {
  localizer_.reset(roughly(start_ * Pose2{0.0, 0.0, kPi - 0.05}));
  at({0.0, 0.0, kPi - 0.05});
  EXPECT_FALSE(at({0.0, 0.0, -kPi + 0.05}).updated);
  EXPECT_TRUE(at({0.0, 0.0, -kPi + 0.2}).updated);
}

TEST_F(TrackingLocalizer, UpdatesWhereItStandsWhileTheScanContradictsTheMap) {
  at({});
  at({});
  const auto elsewhere = laser_.observe(map_, start_ * Pose2{0.0, 0.0, 2.0});
  EXPECT_TRUE(localizer_.update({}, elsewhere).updated);
  EXPECT_TRUE(localizer_.update({}, elsewhere).updated);
}

TEST_F(TrackingLocalizer, UpdatesOnRequestOnce) {
  at({});
  localizer_.requestUpdate();
  EXPECT_TRUE(at({}).updated);
  EXPECT_FALSE(at({}).updated);
}

TEST_F(TrackingLocalizer, KeepsTheCorrectionBetweenUpdates) {
  const Localization first = at({});
  const Localization between = at({0.1, 0.05, 0.1});
  EXPECT_THAT(between.T_map_odom, PoseNear(first.T_map_odom, 0.0, 0.0));
  EXPECT_THAT(between.T_map_base, PoseNear(first.T_map_odom * Pose2{0.1, 0.05, 0.1}, 1e-9, 1e-9));
  EXPECT_THAT(between.T_map_base, PoseNear(start_ * Pose2{0.1, 0.05, 0.1}, 0.1, 0.05));
}

TEST_F(TrackingLocalizer, CorrectsOdometryWhateverItsFrame) {
  const Pose2 T_odom_start{-30.0, 12.0, 2.0};
  const Localization answer = localizer_.update(T_odom_start, laser_.observe(map_, start_));
  EXPECT_THAT(answer.T_map_base, PoseNear(start_, 0.1, 0.05));
  EXPECT_THAT(answer.T_map_odom * T_odom_start, PoseNear(answer.T_map_base, 1e-9, 1e-9));
}

TEST_F(TrackingLocalizer, IgnoresOdometryThatIsNoNumber) {
  const Localization before = at({});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Localization bad = localizer_.update({nan, 0.0, 0.0}, laser_.observe(map_, start_));
  EXPECT_FALSE(bad.updated);
  EXPECT_THAT(bad.T_map_odom, PoseNear(before.T_map_odom, 0.0, 0.0));
  EXPECT_TRUE(at({0.3, 0.0, 0.0}).updated);
}

TEST_F(TrackingLocalizer, IgnoresOdometryBeyondReason) {
  for (const double far : {2e9, 1e300, -std::numeric_limits<double>::max()}) {
    for (const Pose2& odometry : {Pose2{far, 0.0, 0.0}, Pose2{0.0, far, 0.0}}) {
      const Localization before = at({});
      const Localization bad = localizer_.update(odometry, laser_.observe(map_, start_));
      EXPECT_FALSE(bad.updated);
      EXPECT_THAT(bad.T_map_base, PoseNear(before.T_map_base, 0.0, 0.0));
      localizer_.reset(Anywhere{});  // where no update has been yet
      EXPECT_FALSE(localizer_.update(odometry, laser_.observe(map_, start_)).updated);
      localizer_.reset(roughly(start_));
    }
  }
  EXPECT_TRUE(at({0.3, 0.0, 0.0}).updated);
}

TEST_F(TrackingLocalizer, RefusesAnInitialPoseBeyondReason) {
  Gaussian2 prior = roughly(start_);
  prior.mean.y = -2e9;
  EXPECT_THROW(localizer_.reset(prior), std::invalid_argument);
  prior = roughly(start_);
  prior.covariance(0, 0) = 1e200;
  EXPECT_THROW(localizer_.reset(prior), std::invalid_argument);
  prior = roughly(start_);
  prior.covariance(0, 1) = -1e200;
  EXPECT_THROW(localizer_.reset(prior), std::invalid_argument);
  EXPECT_EQ(at({}).status, Status::kTracking);
}

TEST_F(TrackingLocalizer, RefusesAnInitialPoseThatIsNoNumber) {
  Gaussian2 prior = roughly(start_);
  prior.mean.x = std::nan("");
  EXPECT_THROW(localizer_.reset(prior), std::invalid_argument);
  prior = roughly(start_);
  prior.covariance(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(localizer_.reset(prior), std::invalid_argument);
  EXPECT_EQ(at({}).status, Status::kTracking);
}

TEST_F(TrackingLocalizer, StartsAnewOnReset) {
  at({});
  localizer_.reset(roughly({3.0, 1.0, 0.0}));
  const Localization moved = localizer_.update({}, laser_.observe(map_, {3.0, 1.0, 0.0}));
  EXPECT_TRUE(moved.updated);
  EXPECT_THAT(moved.T_map_base, PoseNear(Pose2{3.0, 1.0, 0.0}, 0.1, 0.05));
}

TEST_F(TrackingLocalizer, GoesOnInANewMap) {
  at({});
  const Pose2 here = at({0.3, 0.0, 0.0}).T_map_base;
  localizer_.setMap(asymmetricWorld());
  const Localization after = at({0.3, 0.0, 0.0});
  EXPECT_TRUE(after.updated);
  EXPECT_THAT(after.T_map_base, PoseNear(here, 0.1, 0.05));
  EXPECT_EQ(after.status, Status::kTracking);
}

TEST_F(TrackingLocalizer, KeepsItsMapIfTheNewOneIsUseless) {
  at({});
  EXPECT_THROW(localizer_.setMap(toyWorld({"##"}, 0.1)), std::invalid_argument);
  const Localization after = at({0.3, 0.0, 0.0});
  EXPECT_THAT(after.T_map_base, PoseNear(start_ * Pose2{0.3, 0.0, 0.0}, 0.1, 0.05));
  EXPECT_EQ(after.status, Status::kTracking);
}

}  // namespace
}  // namespace adaptive_localization
