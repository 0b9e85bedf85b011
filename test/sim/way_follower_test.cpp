// SPDX-License-Identifier: BSD-3-Clause
#include "sim/way_follower.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

class Way : public testing::Test {
 protected:
  WayFollower follower(const RouteOptions& options = {}) const {
    WayFollower follower(free_space_, options);
    follower.follow(wayThrough(*free_space_, {2.0, 2.5}, {6.0, 2.5}));
    return follower;
  }

  std::shared_ptr<const FreeSpace> free_space_ =
      std::make_shared<const FreeSpace>(loadSite(worldFile("symmetric"), false).world, 0.29);
};

TEST_F(Way, IsStraightWhereThereIsRoom) {
  const auto way = wayThrough(*free_space_, {2.0, 2.5}, {6.0, 2.5});
  for (const auto& point : way) ASSERT_EQ(point.y(), 2.5);
  for (std::size_t i = 1; i < way.size(); ++i) ASSERT_LT((way[i] - way[i - 1]).norm(), 0.0501);
  EXPECT_EQ(way.back(), Eigen::Vector2d(6.0, 2.5));
}

TEST_F(Way, IsDrivenToItsEndFromBesideIt) {
  RouteOptions options;
  options.route_arrival = 0.03;
  options.route_brakes = true;
  WayFollower follower = this->follower(options);
  Pose2 T_map_base{2.0, 2.7, -1.0};
  double fastest = 0.0, last = 0.0;
  for (int i = 0; i < 2000 && !follower.hasArrived({T_map_base.x, T_map_base.y}); ++i) {
    const Velocity velocity = follower.steer(T_map_base, 0.05);
    T_map_base = T_map_base * arc(velocity, 0.05);
    fastest = std::max(fastest, velocity.forward);
    last = velocity.forward;
    ASSERT_LE(std::abs(velocity.turn), options.route_turn_rate);
  }
  EXPECT_LT(std::hypot(T_map_base.x - 6.0, T_map_base.y - 2.5), 0.03);
  EXPECT_GT(fastest, 0.9 * options.route_speed);
  EXPECT_LT(last, 0.1);
}

TEST_F(Way, IsHeldAgainstADragByTheIntegral) {
  const auto offAtTheEnd = [this](double integral_gain) {
    RouteOptions options;
    options.route_i = integral_gain;
    WayFollower follower = this->follower(options);
    Pose2 T_map_base{2.0, 2.5, 0.0};
    while (T_map_base.x < 5.0) {
      Velocity velocity = follower.steer(T_map_base, 0.05);
      velocity.turn += 0.15;  // rad/s: one wheel is smaller
      T_map_base = T_map_base * arc(velocity, 0.05);
    }
    return std::abs(T_map_base.y - 2.5);
  };
  EXPECT_GT(offAtTheEnd(0.0), 0.01);
  EXPECT_LT(offAtTheEnd(1.0), 0.5 * offAtTheEnd(0.0));
}

TEST_F(Way, TurnsByTheAnglesDerivativeToo) {
  RouteOptions options;
  options.route_p = 0.0;
  options.route_d = 1.0;
  options.route_turn_rate = 8.0;
  WayFollower follower = this->follower(options);
  follower.steer({2.0, 2.5, 0.1}, 0.05);
  EXPECT_NEAR(follower.steer({2.0, 2.5, 0.15}, 0.05).turn, -1.0, 1e-6);
}

TEST_F(Way, IsNowhereBeforeThereIsOne) {
  WayFollower follower(free_space_, {});
  EXPECT_FALSE(follower.hasWay());
  EXPECT_FALSE(follower.hasArrived({0.0, 0.0}));
  EXPECT_FALSE(follower.isOff({0.0, 0.0}));
  EXPECT_EQ(follower.distanceTo({1.0, 1.0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(follower.steer({1.0, 1.0, 0.0}, 0.05).forward, 0.0);
  EXPECT_NEAR(this->follower().distanceTo({3.0, 3.5}), 1.0, 1e-9);
  EXPECT_NEAR(this->follower().distanceTo({3.026, 2.5}), 0.0, 1e-9);  // between two of its points
}

}  // namespace
}  // namespace adaptive_localization
