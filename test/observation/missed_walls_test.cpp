// SPDX-License-Identifier: BSD-3-Clause
#include "observation/missed_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "core/parallel.hpp"
#include "map/ray_caster.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr double kRange = 4.0;  // m

/// A scan of which all beams, this many all around, saw nothing.
Scan openScan(Eigen::Index beams, double max_range = kRange) {
  Scan scan;
  scan.max_range = max_range;
  scan.no_return_bearing =
      Eigen::ArrayXf::LinSpaced(beams, -3.1F, 3.1F - 6.2F / static_cast<float>(beams));
  return scan;
}

Particles randomCloud(Eigen::Index count, int seed) {
  Rng rng(static_cast<std::uint64_t>(seed));
  Particles cloud(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    cloud.setPose(i, {rng.uniform(0.0, 10.0), rng.uniform(0.0, 5.0), rng.uniform(-kPi, kPi)});
  }
  return cloud;
}

/// By exact ray casting: beams that do so beside another one.
double missedOf(const Scan& scan, const Pose2& pose, const RayCaster& caster) {
  const Eigen::Vector2d sensor = pose * scan.position;
  std::vector<bool> is_missed{false};
  for (const float bearing : scan.no_return_bearing) {
    const Pose2 ray{sensor.x(), sensor.y(), wrapAngle(pose.theta + static_cast<double>(bearing))};
    const double range = caster.range(ray * Pose2{0.4, 0.0, 0.0}, kRange) + 0.4;
    is_missed.push_back(range < 0.9 * kRange - 0.2);
  }
  is_missed.push_back(false);
  double missed = 0.0;
  for (std::size_t k = 1; k + 1 < is_missed.size(); ++k) {
    missed += is_missed[k] && (is_missed[k - 1] || is_missed[k + 1]) ? 1.0 : 0.0;
  }
  return missed;
}

TEST(MissedWalls, AreThoseThatRaysMeet) {
  for (const Pose2& origin : {Pose2{}, Pose2{3.0, -2.0, 0.7}}) {
    const auto map = asymmetricWorld(origin);
    const DistanceField field(*map);
    const RayCaster caster(map);
    Scan scan = openScan(24);
    scan.position = {0.2, 0.1};
    Particles cloud = randomCloud(300, 1);
    for (Eigen::Index i = 0; i < cloud.size(); ++i) cloud.setPose(i, origin * cloud.pose(i));
    const Eigen::ArrayXd missed = missedWalls(scan, cloud, field);
    double off = 0.0, all = 0.0;
    for (Eigen::Index i = 0; i < cloud.size(); ++i) {
      const double exact = missedOf(scan, cloud.pose(i), caster);
      all += exact;
      off += std::abs(missed[i] - exact);
      EXPECT_NEAR(missed[i], exact, 3.0);  // a corner may be missed
    }
    EXPECT_GT(all, 2000.0);
    EXPECT_LT(off, 0.02 * all);
  }
}

TEST(MissedWalls, StandForTheBeamsBesideThem) {
  const auto map = asymmetricWorld();
  const DistanceField field(*map);
  Particles corner(1);
  corner.setPose(0, {1.0, 1.0, 0.0});
  const double of_all = missedWalls(openScan(24), corner, field)[0];
  EXPECT_GT(of_all, 5.0);
  EXPECT_NEAR(missedWalls(openScan(240), corner, field)[0], 10.0 * of_all, 15.0);
  const Particles many = randomCloud(30000, 2);  // of which fewer rays are followed
  const Eigen::ArrayXd some = missedWalls(openScan(240), many, field);
  EXPECT_NEAR(some.mean(), 10.0 * missedWalls(openScan(24), many, field).mean(), 10.0);
}

TEST(MissedWalls, AreNoneWhereTheLaserDoesNotReach) {
  const auto map = toyWorld({Art(1, std::string(100, '.') + "#").front()}, 0.05);
  const DistanceField field(*map);  // a wall at 5.025 m
  Particles ahead(1);
  Scan scan = openScan(2);
  scan.no_return_bearing = 0.0F;
  const auto missedFrom = [&](double x) {
    ahead.setPose(0, {x, 0.025, 0.0});
    return missedWalls(scan, ahead, field)[0];
  };
  EXPECT_EQ(missedFrom(1.0), 0.0);  // 4.0 m: at the end of its range
  EXPECT_EQ(missedFrom(1.5), 0.0);  // 3.5 m: nearly
  EXPECT_EQ(missedFrom(1.8), 2.0);  // 3.2 m
  EXPECT_EQ(missedFrom(4.5), 2.0);
  EXPECT_EQ(missedFrom(4.9), 0.0);  // where the robot stands
  EXPECT_EQ(missedFrom(7.0), 0.0);  // it looks away from the map
  EXPECT_EQ(missedFrom(1e9), 0.0);
  EXPECT_EQ(missedFrom(std::nan("")), 0.0);
}

TEST(MissedWalls, AreNoneWhereOneBeamAloneGoesThrough) {
  const auto map = toyWorld({Art(1, std::string(60, '.') + "#").front()}, 0.05);
  const DistanceField field(*map);
  Particles ahead(1);
  ahead.setPose(0, {1.0, 0.025, 0.0});
  Scan scan = openScan(5);
  const auto missedBy = [&](std::array<float, 5> bearings) {
    std::copy(bearings.begin(), bearings.end(), scan.no_return_bearing.data());
    return missedWalls(scan, ahead, field)[0];
  };
  EXPECT_EQ(missedBy({1.5F, 0.0F, -1.5F, 0.0F, 1.5F}), 0.0);
  EXPECT_EQ(missedBy({0.0F, 0.0F, -1.5F, 0.0F, 1.5F}), 2.0);
  EXPECT_EQ(missedBy({1.5F, 0.0F, 0.0F, 0.0F, 1.5F}), 3.0);
  EXPECT_EQ(missedBy({0.0F, 0.0F, 1.5F, 0.0F, 0.0F}), 4.0);
}

TEST(MissedWalls, AreNoneWithoutNoReturnsOrParticles) {
  const auto map = asymmetricWorld();
  const DistanceField field(*map);
  EXPECT_EQ(missedWalls(openScan(0), randomCloud(3, 1), field).sum(), 0.0);
  EXPECT_EQ(missedWalls(openScan(10), Particles(0), field).size(), 0);
}

TEST(MissedWalls, AreTheSameForAnyNumberOfThreads) {
  const auto map = asymmetricWorld();
  const DistanceField field(*map);
  const Particles cloud = randomCloud(5000, 3);
  setThreads(1);
  const Eigen::ArrayXd by_one = missedWalls(openScan(60), cloud, field);
  setThreads(4);
  const Eigen::ArrayXd by_four = missedWalls(openScan(60), cloud, field);
  setThreads(1);
  EXPECT_TRUE((by_one == by_four).all());
}

TEST(OpenScan, HasMoreNoReturnsThanHits) {
  Scan scan = openScan(10);
  EXPECT_TRUE(isMostlyOpen(scan));
  scan.range = Eigen::ArrayXf::Ones(9);
  EXPECT_TRUE(isMostlyOpen(scan));
  scan.range = Eigen::ArrayXf::Ones(10);
  EXPECT_FALSE(isMostlyOpen(scan));
  EXPECT_FALSE(isMostlyOpen(Scan{}));
}

}  // namespace
}  // namespace adaptive_localization
