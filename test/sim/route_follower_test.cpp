// SPDX-License-Identifier: BSD-3-Clause
#include "sim/route_follower.hpp"

#include <gmock/gmock.h>

#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

SimulationOptions driving(const std::string& name) {
  SimulationOptions options;
  options.world = worldFile(name);
  options.drive = true;
  return options;
}

class Worlds : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, Worlds, testing::ValuesIn(kWorlds),
                         [](const auto& world) { return world.param; });

TEST_P(Worlds, TheRobotDrivesRoundWithoutTouchingAnything) {
  const SimulationOptions options = driving(GetParam());
  Simulation simulation = Simulation::load(options);
  const auto world = loadSite(options.world, false).world;
  const auto laps = 2 * static_cast<int>(simulation.driver().route().size());
  while (simulation.time() < 1000.0 && simulation.driver().reached() < laps) {
    simulation.step();
    const Pose2& truth = simulation.truth();
    ASSERT_GE(world->clearance({truth.x, truth.y}, 0.5), options.base.robot_radius);
  }
  EXPECT_EQ(simulation.driver().reached(), laps);
}

TEST_P(Worlds, TheRobotGetsGoingFromAnywhere) {
  SimulationOptions options = driving(GetParam());
  options.start = "random";
  options.furniture = true;
  Simulation simulation = Simulation::load(options);
  for (int round = 0; round < 25; ++round) {
    simulation.kidnapRandom();
    const int before = simulation.driver().reached();
    const double begin = simulation.time();
    while (simulation.time() < begin + 250.0 && simulation.driver().reached() < before + 2) {
      simulation.step();
    }
    EXPECT_GE(simulation.driver().reached(), before + 2) << "round " << round;
  }
}

TEST_P(Worlds, PeopleHoldTheRobotUpButNotForEver) {
  SimulationOptions options = driving(GetParam());
  options.people = 4;
  options.furniture = true;
  Simulation simulation = Simulation::load(options);
  const auto lap = static_cast<int>(simulation.driver().route().size());
  double nearest = 10.0;
  while (simulation.time() < 1200.0 && simulation.driver().reached() < lap) {
    simulation.step();
    for (const auto& person : simulation.people()) {
      nearest = std::min(nearest, std::hypot(person.x() - simulation.truth().x,
                                             person.y() - simulation.truth().y));
    }
  }
  EXPECT_GE(simulation.driver().reached(), lap);
  EXPECT_GT(nearest, options.base.robot_radius + People::kRadius - 0.02);
}

TEST(RouteFollower, ACommandTakesOverAndTheDriveGoesOnAfterIt) {
  Simulation simulation = Simulation::load(driving("symmetric"));
  for (int i = 0; i < 300; ++i) simulation.step();
  for (int i = 0; i < 200; ++i) {
    simulation.command({0.0, 0.5});
    simulation.step();
  }
  EXPECT_NEAR(simulation.velocity().forward, 0.0, 1e-9);
  EXPECT_NEAR(simulation.velocity().turn, 0.5, 1e-9);
  const int before = simulation.driver().reached();
  for (int i = 0; i < 6000; ++i) simulation.step();
  EXPECT_GT(simulation.driver().reached(), before + 2);
}

TEST(RouteFollower, WandersWhereThereIsNoRoute) {
  SimulationOptions options = driving("maze");
  options.world = mapFile("maze");
  Simulation simulation = Simulation::load(options);
  for (int i = 0; i < 12000; ++i) simulation.step();
  EXPECT_GE(simulation.driver().reached(), 4);
}

TEST(FreeSpace, LeavesOutWhatTheRobotCannotReach) {
  const auto world = loadSite(worldFile("maze"), false).world;
  const FreeSpace space(world, 0.29);
  EXPECT_TRUE(space.contains({0.8, 0.8}));
  EXPECT_GE(world->clearance({6.6, 2.9}, 1.0), 0.29);  // room enough, but no way in
  EXPECT_FALSE(space.contains({6.6, 2.9}));
  EXPECT_FALSE(space.isFree({{0.8, 0.8}, {4.6, 1.6}}, 0.0));
  const auto way = space.path({0.8, 0.8}, {4.6, 1.6});
  EXPECT_LT((way.back() - Eigen::Vector2d(4.6, 1.6)).norm(), 0.05);
  for (std::size_t i = 1; i < way.size(); ++i) {
    ASSERT_TRUE(space.contains(way[i]));
    ASSERT_LT((way[i] - way[i - 1]).norm(), 0.0708);
  }
  EXPECT_THROW(FreeSpace(world, 3.0), std::invalid_argument);
}

}  // namespace
}  // namespace adaptive_localization
