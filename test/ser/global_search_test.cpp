// SPDX-License-Identifier: BSD-3-Clause
#include "ser/global_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.hpp"
#include "ser/place_search.hpp"
#include "ser_toys.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

/// Poses for a robot of 0.2 m radius in a map.
Pose2 standingPose(Rng& rng, const OccupancyGrid& map, const DistanceField& field) {
  for (;;) {
    const Cell cell = map.lattice().cell(rng.below(map.lattice().size()));
    const Eigen::Vector2d centre = map.lattice().centre(cell);
    if (!map.isFree(cell) || field.at(centre) < 0.2) continue;
    return {centre.x() + rng.uniform(-0.02, 0.02), centre.y() + rng.uniform(-0.02, 0.02),
            rng.uniform(-kPi, kPi)};
  }
}

/// With 31 mm of noise and 5 % of beams that read anything.
Scan scanOf(const World& world, const Pose2& pose, Rng& rng) {
  LaserScan message;
  message.angle_min = -kPi / 2;
  message.angle_increment = kPi / 180;
  message.range_max = 20.0;
  for (int i = 0; i <= 180; ++i) {
    const double theta = pose.theta + message.angle_min + i * message.angle_increment;
    message.ranges.push_back(
        static_cast<float>(world.range({pose.x, pose.y, theta}, message.range_max)));
  }
  Disturbance{0.031, 0.05, 0.0, 0.0}.apply(message, rng);
  return toScan(message);
}

/// Half a circle does not tell one corner of the maze from another where no more is in view: then
/// several places fit equally well and all are named.
TEST(GlobalSearch, FindsWhereAScanOfTheRealMazeWasTaken) {
  const MapPtr map = maze();
  const DistanceField field(*map);
  const auto world = makeWorld(mazePlan(), false);
  const auto search = searchOn(gridOf(map), map);
  Rng rng(1);
  constexpr int kScans = 200;
  int named = 0, first = 0, single = 0, single_and_wrong = 0;
  std::vector<double> visited;
  for (int n = 0; n < kScans; ++n) {
    const Pose2 truth = standingPose(rng, *map, field);
    const auto places = findPlaces(search, scanOf(*world, truth, rng));
    visited.push_back(search->visitedShare());
    const auto isRight = [&](const Place& place) {
      const double turned = std::abs(wrapAngle(place.T_map_base.theta - truth.theta));
      return distance(place.T_map_base, truth) < 0.15 && turned < 0.09;
    };
    named += std::any_of(places.begin(), places.end(), isRight) ? 1 : 0;
    if (places.empty()) continue;
    first += isRight(places.front()) ? 1 : 0;
    single += places.size() == 1 ? 1 : 0;
    single_and_wrong += places.size() == 1 && !isRight(places.front()) ? 1 : 0;
  }
  EXPECT_GE(named, kScans * 99 / 100);
  EXPECT_GE(first, kScans * 9 / 10);
  EXPECT_GE(single, kScans / 2);
  EXPECT_EQ(single_and_wrong, 0);
  std::nth_element(visited.begin(), visited.begin() + kScans / 2, visited.end());
  EXPECT_LE(visited[kScans / 2], 0.05);
}

TEST(GlobalSearch, FindsTheRobotWhoseLaserAndMapAreTurned) {
  const Pose2 origin{2.0, -1.0, -2.2};
  const MapPtr map = asymmetricWorld(origin);
  const LaserMount mount = LaserMount::upsideDown({0.15, 0.05, 0.4});
  const Pose2 truth = origin * Pose2{2.53, 3.51, 0.4};
  const Pose2 laser = truth * Pose2{0.15, 0.05, 0.4};
  LaserScan message = kHalfCircle.read(map, laser);
  std::reverse(message.ranges.begin(), message.ranges.end());  // as seen upside down
  const Scan scan = toScan(message, mount, ScanOptions{});
  const auto places = findPlaces(searchOn(gridOf(map, geometryOf(scan, 10.0)), map), scan);
  ASSERT_FALSE(places.empty());
  EXPECT_THAT(places.front().T_map_base, PoseNear(truth, 0.05, 0.03));
}

TEST(GlobalSearch, NamesBothOfTwins) {
  const MapPtr map = symmetricWorld();
  const auto search = searchOn(gridOf(map), map);
  const Pose2 truth{2.3, 0.8, 0.4};
  const Pose2 twin{6.0 - truth.x, 3.0 - truth.y, wrapAngle(truth.theta + kPi)};
  const auto places = findPlaces(search, toScan(kHalfCircle.read(map, truth)));
  ASSERT_GE(places.size(), 2U);
  const auto first = places[0].T_map_base, second = places[1].T_map_base;
  EXPECT_TRUE(distance(first, truth) < 0.05 || distance(first, twin) < 0.05);
  EXPECT_TRUE(distance(second, truth) < 0.05 || distance(second, twin) < 0.05);
  EXPECT_GT(distance(first, second), 0.5);
}

TEST(GlobalSearch, GivesDistinctPlacesByAscendingError) {
  const MapPtr map = maze();
  GlobalSearchOptions options;
  options.search_margin = 0.3;
  options.search_max_places = 7;
  const auto search = searchOn(gridOf(map), map, options);
  const auto places = findPlaces(search, toScan(kHalfCircle.read(map, {0.8, 0.8, 1.5})));
  EXPECT_GT(places.size(), 1U);
  EXPECT_LE(places.size(), 7U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_GE(places[i].error, i > 0 ? places[i - 1].error : 0.0);
    EXPECT_LE(places[i].error, options.search_truncation);
    for (std::size_t j = 0; j < i; ++j) {
      const Pose2 a = places[i].T_map_base, b = places[j].T_map_base;
      EXPECT_TRUE(distance(a, b) >= 0.5 || std::abs(wrapAngle(a.theta - b.theta)) >= kPi / 9);
    }
  }
}

TEST(GlobalSearch, FindsNothingForScansThatTellNothing) {
  const MapPtr map = smallRoom();
  const auto search = searchOn(gridOf(map), map);
  LaserScan message = kHalfCircle.read(map, {1.5, 1.0, 0.0});
  EXPECT_TRUE(findPlaces(search, Scan{}).empty());
  for (const float nothing : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    std::fill(message.ranges.begin(), message.ranges.end(), nothing);
    EXPECT_TRUE(findPlaces(search, toScan(message)).empty()) << nothing;
  }
}

TEST(GlobalSearch, OutlivesScansOfAFewBeams) {
  const MapPtr map = maze();
  const auto search = searchOn(gridOf(map), map);
  LaserScan message = kHalfCircle.read(map, {0.8, 0.8, 1.5});
  for (std::size_t i = 1; i < message.ranges.size(); ++i) message.ranges[i] = std::nanf("");
  const auto places = findPlaces(search, toScan(message));
  EXPECT_GT(places.size(), 1U);
  EXPECT_LE(places.size(), 100U);
  EXPECT_LT(places.front().error, 0.05);
}

TEST(GlobalSearch, IsTheSameForAnyNumberOfThreads) {
  const MapPtr map = maze();
  const auto search = searchOn(gridOf(map), map);
  Rng rng(2);
  for (int n = 0; n < 6; ++n) {
    const DirectionalScan scan = randomScan(rng, 91);
    const auto one = search->findPoses(scan);
    const double visited = search->visitedShare();
    setThreads(4);
    const auto four = search->findPoses(scan);
    setThreads(1);
    ASSERT_EQ(one.size(), four.size());
    EXPECT_EQ(visited, search->visitedShare());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(one[i].cell, four[i].cell);
      ASSERT_EQ(one[i].direction, four[i].direction);
      ASSERT_EQ(one[i].cost, four[i].cost);
    }
  }
}

TEST(GlobalSearch, LooksAtNoMorePosesThanItMay) {
  const auto map = maze();
  const auto grid = gridOf(map);
  constexpr double kNode = (1.0 + 4.0 * 4.0) * 3.0;  // poses and bounds that are looked at together
  Rng rng(7);
  for (int n = 0; n < 50; ++n) {
    GlobalSearchOptions options;
    options.search_max_visits = static_cast<int>(std::exp(rng.uniform(0.0, 12.0)));
    options.search_margin = std::exp(rng.uniform(-10.0, 13.0));
    options.search_max_error = std::exp(rng.uniform(-10.0, 13.0));
    options.search_truncation = std::exp(rng.uniform(-13.0, 13.0));
    const auto search = searchOn(grid, map, options);
    search->findPoses(randomScan(rng, 91));
    const double poses = static_cast<double>(grid->ranges().size()) * kDirections;
    EXPECT_LE(search->visitedShare() * poses, options.search_max_visits + kNode);
  }
}

}  // namespace
}  // namespace adaptive_localization
