// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/filters/swarm_fix.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <string>

#include "../../src/filters/swarm_bats.hpp"
#include "particle/gaussian_cloud.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr double kMaxRange = 12.0;

/// A world with somebody in it who looks for a robot without matching scans.
struct Scene {
  explicit Scene(const Pose2& origin, const SwarmFixOptions& options = plain())
      : T_map_world(origin),
        map(asymmetricWorld(origin)),
        field(std::make_shared<const DistanceField>(*map)),
        places(std::make_shared<Places>(map, field, EnergyGridOptions{}, GlobalSearchOptions{})),
        fixer(options, RangeObjectiveOptions{}, LeaderOptions{}, kMaxRange, map, field, places,
              castOverCells(map, field)) {}

  static SwarmFixOptions plain() {
    SwarmFixOptions options;
    options.swarm_match = false;
    return options;
  }

  Observations observe(const Pose2& T_world_base) const {
    return ToyLaser{61, -2.0, 2.0, kMaxRange}.observe(map, T_map_world * T_world_base);
  }

  /// How far off, in x, y and heading of the world, a swarm finds a robot that is there.
  Eigen::Vector3d errorOf(const Pose2& T_world_base, std::uint64_t seed) {
    Rng rng(seed);
    const Gaussian2 odometry{T_map_world * T_world_base * Pose2{0.1, -0.06, 0.03},
                             Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()};
    const Particles start = drawCloud(odometry, 400, rng);
    const BatMove move(BatOptions{}, LeaderOptions{});
    const SwarmFix fix = fixer.fixNear(odometry, start, move, observe(T_world_base), rng);
    const Pose2 found = inverse(T_map_world) * fix.estimate.T_map_base;
    return {found.x - T_world_base.x, found.y - T_world_base.y,
            wrapAngle(found.theta - T_world_base.theta)};
  }

  Pose2 T_map_world;
  std::shared_ptr<const OccupancyGrid> map;
  std::shared_ptr<const DistanceField> field;
  std::shared_ptr<Places> places;
  SwarmFixer fixer;
};

TEST(SwarmFixer, FindsARobotThatHeadsForPiAsWellAsTheSameOneHalfATurnOn) {
  for (const char* near : {"hits", "ranges"}) {
    SwarmFixOptions options = Scene::plain();
    options.swarm_near = near;
    Scene scene(Pose2{}, options), turned(Pose2{10.0, 5.0, kPi}, options);
    for (const double heading : {0.01, -0.01, kPi - 0.01, 0.01 - kPi}) {
      const Pose2 robot{3.0, 1.2, heading};
      Eigen::Vector3d squares = Eigen::Vector3d::Zero(), turned_squares = squares;
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        squares += scene.errorOf(robot, seed).cwiseAbs2() / 20.0;
        turned_squares += turned.errorOf(robot, seed).cwiseAbs2() / 20.0;
      }
      const Eigen::Vector3d rms = squares.cwiseSqrt(), turned_rms = turned_squares.cwiseSqrt();
      EXPECT_LT((rms - turned_rms).cwiseAbs().maxCoeff(), 0.005) << near << " " << heading;
      EXPECT_LT(rms.maxCoeff(), 0.04);
    }
  }
}

TEST(SwarmFixer, OnATorusBatsThatLeaveAtOneEndComeBackAtTheOther) {
  const Pose2 truth{9.2, 0.8, 2.8};
  std::map<bool, int> found;  // of 20
  for (const bool is_torus : {false, true}) {
    SwarmFixOptions options = Scene::plain();
    options.wrap_map = is_torus;
    Scene scene(Pose2{}, options);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Rng rng(seed);
      const Gaussian2 other_end{{0.8, 0.8, 2.8}, Eigen::Vector3d(0.04, 0.04, 0.04).asDiagonal()};
      const Particles start = drawCloud(other_end, 100, rng);
      const BatMove move(BatOptions{}, LeaderOptions{});
      const SwarmFix fix = scene.fixer.fix(start, move, scene.observe(truth), rng);
      found[is_torus] += distance(fix.estimate.T_map_base, truth) < 0.2 ? 1 : 0;
    }
  }
  EXPECT_LE(found[false], 3);  // it leads through two walls
  EXPECT_GE(found[true], 7);
}

TEST(SwarmFixer, CostsAreOfRangesWhateverTheSwarmMadeSmall) {
  for (const char* near : {"hits", "ranges"}) {
    SwarmFixOptions options = Scene::plain();
    options.swarm_near = near;
    Scene scene(Pose2{}, options);
    const Pose2 truth{3.0, 1.2, 1.0};
    const Observations seen = scene.observe(truth);
    Rng rng(1);
    const Gaussian2 odometry{{3.3, 1.2, 1.0}, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()};
    const Particles start = drawCloud(odometry, 100, rng);
    const BatMove move(BatOptions{}, LeaderOptions{});
    const SwarmFix fix = scene.fixer.fixNear(odometry, start, move, seen, rng);
    EXPECT_EQ(fix.cost, scene.fixer.costOf(fix.estimate.T_map_base, seen)) << near;
    EXPECT_EQ(fix.has_odometry, std::string(near) == "hits");
  }
}

TEST(SwarmFixer, FliesAsManyBatsAsTheBudgetLetsIt) {
  SwarmFixOptions options = Scene::plain();
  options.swarm_budget = 0.1;  // 0.1e6 / 10 / (60 beams + 25 + 3 leaders)
  Scene scene(Pose2{}, options);
  EXPECT_EQ(scene.fixer.affordable(100), 100);
  EXPECT_EQ(scene.fixer.affordable(1000), 113);
  Rng rng(1);
  const Gaussian2 known{{3.0, 1.2, 1.0}, Eigen::Matrix3d::Identity()};
  const Particles start = drawCloud(known, 1000, rng);
  const BatMove move(BatOptions{}, LeaderOptions{});
  const Observations seen = scene.observe(known.mean);
  EXPECT_EQ(scene.fixer.fix(start, move, seen, rng).bats.size(), 113);
  EXPECT_LE(scene.fixer.fix(start, move, seen, rng).iterations, 9);
}

TEST(SwarmPrice, IsThatOfBeamsOfTheMoveAndOfLeaders) {
  const LeaderOptions one_each{1, 1, "nearest_leader"};
  EXPECT_EQ(SwarmPrice(60, false, {}).ofOne(1000000), 85.0);
  EXPECT_EQ(SwarmPrice(60, true, {}).ofOne(400), 9025.0);
  EXPECT_EQ(SwarmPrice(60, false, one_each).ofOne(5000), 5085.0);
  for (const bool is_cast : {false, true}) {
    const SwarmPrice price(60, is_cast, one_each);
    const auto count = price.affordable(5000, 1e7);
    const auto costOf = [&](Eigen::Index n) {
      return 10.0 * static_cast<double>(n) * price.ofOne(n);
    };
    EXPECT_LE(costOf(count), 1e7);
    EXPECT_GT(costOf(count + 1), 1e7);
    EXPECT_EQ(price.affordable(50, 1e7), 50);
    EXPECT_EQ(price.affordable(5000, 1.0), 2);
  }
}

TEST(SwarmBats, HeadingsAboutPiLieTogether) {
  Particles bats(2);
  bats.setPose(0, {1.0, 2.0, kPi - 0.1});
  bats.setPose(1, {1.0, 2.0, 0.1 - kPi});
  const Eigen::ArrayXXd columns = columnsAround(kPi - 0.2, bats);
  EXPECT_NEAR(columns(0, 2), kPi - 0.1, 1e-12);
  EXPECT_NEAR(columns(1, 2), kPi + 0.1, 1e-12);
  EXPECT_EQ(columns(1, 0), 1.0);
  const SearchSpace space = spaceAround(columns);
  EXPECT_NEAR(space.low[2], kPi - 0.22, 1e-12);
  EXPECT_NEAR(space.high[2], kPi + 0.22, 1e-12);
}

TEST(SwarmBats, HeadingsOfAWideCloudAreAWholeTurn) {
  Particles bats(2);
  bats.setPose(0, {1.0, 2.0, -2.5});
  bats.setPose(1, {1.0, 2.0, 2.0});
  const SearchSpace space = spaceAround(columnsAround(0.0, bats));
  EXPECT_NEAR(space.width(2), 2.0 * kPi, 1e-12);
  EXPECT_TRUE(space.wraps(2));
  EXPECT_NEAR(space.width(0), 0.04, 1e-12);
}

TEST(SwarmBats, AreThinnedEvenly) {
  Eigen::ArrayXXd rows(10, 1);
  rows.col(0).setLinSpaced(0.0, 9.0);
  const Eigen::ArrayXXd some = thinned(rows, 4);
  EXPECT_TRUE((some.col(0) == Eigen::Array4d(0.0, 2.0, 5.0, 7.0)).all());
  EXPECT_EQ(thinned(rows, 10).rows(), 10);
  EXPECT_EQ(thinned(rows, 20).rows(), 10);
}

}  // namespace
}  // namespace adaptive_localization
