// SPDX-License-Identifier: BSD-3-Clause
#include "sim/simulation.hpp"

#include <gmock/gmock.h>

#include <cstring>

#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

/// Everything a simulation says in some seconds, bit by bit.
std::vector<float> record(const SimulationOptions& options, double seconds) {
  Simulation simulation = simulateHall(options);
  std::vector<float> all;
  while (simulation.time() < seconds) {
    if (simulation.time() > 1.0 && simulation.time() < 3.0) simulation.command({0.3, 0.2});
    const Sensed sensed = simulation.step();
    if (sensed.scan) all.insert(all.end(), sensed.scan->ranges.begin(), sensed.scan->ranges.end());
    if (sensed.odometry) {
      const Pose2& pose = sensed.odometry->T_odom_base;
      for (const double value : {pose.x, pose.y, pose.theta}) all.push_back(float(value));
    }
  }
  return all;
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

template <class Action>
std::string errorOf(Action&& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

SimulationOptions busy() {
  SimulationOptions options;
  options.drive = true;
  options.furniture = true;
  options.people = 3;
  return options;
}

TEST(Simulation, SameSeedAndCommandsGiveTheSameBits) {
  SimulationOptions options = busy();
  const auto first = record(options, 20.0);
  EXPECT_TRUE(sameBits(first, record(options, 20.0)));
  options.seed = 2;
  EXPECT_FALSE(sameBits(first, record(options, 20.0)));
}

TEST(Simulation, ScansAndOdometryComeAtTheirRates) {
  SimulationOptions options;
  options.scan_rate = 5.0;
  options.odom_rate = 50.0;
  Simulation simulation = simulateHall(options);
  int scans = 0;
  int readings = 0;
  for (int i = 0; i < 1000; ++i) {
    const Sensed sensed = simulation.step();
    if (sensed.scan) {
      ++scans;
      EXPECT_NEAR(sensed.scan->stamp, simulation.time(), 1e-9);
      EXPECT_TRUE(sensed.odometry.has_value());
    }
    if (sensed.odometry) ++readings;
  }
  EXPECT_EQ(scans, 50);
  EXPECT_EQ(readings, 500);
}

/// A LMS-291 turns 75 times a second: rates need not be those of the steps.
TEST(Simulation, ScansAndOdometryShowTheInstantOfTheirStamp) {
  for (const double rate : {75.0, 37.5, 30.0, 7.0}) {
    SimulationOptions options;
    options.profile = "ideal";
    options.odometry = OdometryOptions::profile("ideal");
    options.scan_rate = options.odom_rate = rate;
    options.laser.laser_noise = options.laser.laser_bias = options.laser.laser_short = 0.0;
    options.laser.laser_resolution = 0.0;
    Simulation simulation = simulateHall(options);
    const double start = simulation.truth().x;
    int scans = 0;
    for (int i = 0; i < 600; ++i) {
      simulation.command({0.5, 0.0});
      const Sensed sensed = simulation.step();
      ASSERT_EQ(sensed.scan.has_value(), sensed.odometry.has_value());
      if (!sensed.scan) continue;
      ++scans;
      EXPECT_NEAR(sensed.scan->stamp, scans / rate, 1e-9);
      EXPECT_NEAR(sensed.odometry->stamp, scans / rate, 1e-9);
      const double driven = simulation.truth().x - start -
                            simulation.velocity().forward * (simulation.time() - scans / rate);
      EXPECT_NEAR(sensed.odometry->T_odom_base.x, driven, 1e-9);
      const double meanwhile =  // until the beam ahead
          simulation.velocity().forward * 90.0 * static_cast<double>(sensed.scan->time_increment);
      EXPECT_NEAR(sensed.scan->ranges[90], 10.0 - start - driven - meanwhile - 0.021, 1e-5);
    }
    EXPECT_EQ(scans, static_cast<int>(6.0 * rate + 1e-6)) << rate;
  }
}

TEST(Simulation, ALateScanShowsWhereTheRobotWas) {
  SimulationOptions options;
  options.laser.laser_latency = 0.1;
  options.laser.laser_noise = options.laser.laser_bias = options.laser.laser_short = 0.0;
  Simulation simulation = simulateHall(options);
  std::vector<double> ahead;  // true range to the wall in front, by step
  for (int i = 0; i < 400; ++i) {
    simulation.command({0.5, 0.0});
    const Sensed sensed = simulation.step();
    ahead.push_back(10.0 - simulation.truth().x - 0.021);
    if (!sensed.scan || i < 200) continue;
    EXPECT_NEAR(sensed.scan->stamp, simulation.time(), 1e-9);
    EXPECT_NEAR(sensed.scan->ranges[90], ahead[ahead.size() - 11], 0.0051);
  }
}

TEST(Simulation, AWallStopsTheRobotWithoutTouch) {
  SimulationOptions options;
  options.start = "1,1,3.14159265";
  Simulation simulation = simulateHall(options);
  for (int i = 0; i < 500; ++i) {
    simulation.command({0.5, 0.0});
    simulation.step();
    ASSERT_GE(simulation.truth().x, options.base.robot_radius - 1e-9);
  }
  EXPECT_LT(simulation.truth().x, options.base.robot_radius + 0.02);
  for (int i = 0; i < 300; ++i) {
    simulation.command({0.5, 1.0});  // it can turn away
    simulation.step();
  }
  EXPECT_GT(simulation.truth().x, options.base.robot_radius + 0.1);
}

TEST(Simulation, AnOmnidirectionalRobotWithTwoLasersSeesAllAroundAndNeedNotTurn) {
  SimulationOptions options;
  options.drive = true;
  options.base.base = "omni";
  options.odometry = OdometryOptions::profile("ideal");
  options.laser.lasers = 2;
  options.laser.laser_view = 270.0;
  options.laser.laser_beams = 271;
  options.laser.laser_x = options.laser.laser_y = 0.15;
  options.laser.laser_yaw = kPi / 4.0;
  Simulation simulation = simulateHall(options);
  double most_aside = 0.0;
  int pairs = 0;
  while (simulation.driver().reached() < 4 && simulation.time() < 300.0) {
    const Sensed sensed = simulation.step();
    most_aside = std::max(most_aside, std::abs(simulation.velocity().aside));
    ASSERT_EQ(sensed.scan.has_value(), sensed.second_scan.has_value());
    if (!sensed.scan) continue;
    ++pairs;
    EXPECT_EQ(sensed.scan->stamp, sensed.second_scan->stamp);
    EXPECT_NE(sensed.scan->ranges, sensed.second_scan->ranges);
  }
  EXPECT_EQ(simulation.driver().reached(), 4);
  EXPECT_GT(most_aside, 0.2);
  EXPECT_GT(pairs, 100);
  const Pose2 T_map_odom = simulation.truth() * inverse(simulation.odometry().T_odom_base);
  EXPECT_NEAR(T_map_odom.x, 1.0, 1e-6);  // where it started
  EXPECT_NEAR(T_map_odom.y, 1.0, 1e-6);
}

TEST(Simulation, ADriverWhoDoesNotKnowTheTruthSteersByWhereTheRobotIsLocalized) {
  SimulationOptions options;
  options.drive = true;
  options.drive_by = "estimate";
  options.odometry = OdometryOptions::profile("ideal");
  options.route.route_arrival = 0.03;
  options.route.route_brakes = true;
  Simulation simulation = simulateHall(options);
  const Pose2 start = simulation.truth();
  for (int i = 0; i < 200; ++i) simulation.step();
  EXPECT_EQ(simulation.truth().x, start.x) << "it drives though nobody localizes it";
  const Pose2 wrong{start.x + 0.2, start.y, start.theta};  // T_map_odom: 0.2 m too far
  simulation.localize(wrong);
  while (simulation.driver().reached() == 0 && simulation.time() < 100.0) simulation.step();
  ASSERT_EQ(simulation.driver().reached(), 1);
  const Eigen::Vector2d off = Eigen::Vector2d(simulation.truth().x, simulation.truth().y) -
                              simulation.driver().lastReached();
  EXPECT_NEAR(off.x(), -0.2, 0.05);
  EXPECT_NEAR(off.y(), 0.0, 0.05);
}

TEST(Simulation, CarryingTheRobotDoesNotTurnItsWheels) {
  SimulationOptions options;
  options.odometry = OdometryOptions::profile("ideal");
  Simulation simulation = simulateHall(options);
  for (int i = 0; i < 200; ++i) {
    simulation.command({0.4, 0.1});
    simulation.step();
  }
  const Pose2 before = simulation.odometry().T_odom_base;
  simulation.kidnap({8.0, 4.0, 2.0});
  EXPECT_EQ(simulation.truth().x, 8.0);
  EXPECT_EQ(simulation.truth().theta, 2.0);
  simulation.step();
  const Pose2 after = simulation.odometry().T_odom_base;
  EXPECT_EQ(after.x, before.x);
  EXPECT_EQ(after.y, before.y);
  EXPECT_EQ(after.theta, before.theta);
  simulation.reset();
  EXPECT_EQ(simulation.truth().x, 1.0);
}

TEST(Simulation, PutsTheRobotOnlyWhereItCanStand) {
  Simulation simulation = simulateHall({});
  const auto world = makeWorld(hall(), false);
  const auto room = [&] {
    return world->clearance({simulation.truth().x, simulation.truth().y}, 1.0);
  };
  simulation.kidnap({4.5, 2.5, 0.0});  // into the column
  EXPECT_GE(room(), 0.28);
  EXPECT_LT(distance(simulation.truth(), {4.5, 2.5, 0.0}), 1.2);
  simulation.kidnap({-20.0, 50.0, 0.0});
  EXPECT_GE(room(), 0.28);
  double farthest = 0.0;
  for (int i = 0; i < 100; ++i) {
    simulation.kidnapRandom();
    EXPECT_GE(room(), 0.28);
    farthest = std::max(farthest, distance(simulation.truth(), {1.0, 1.0, 0.0}));
  }
  EXPECT_GT(farthest, 6.0);
}

TEST(Simulation, AStartThatIsNoneIsNamed) {
  SimulationOptions options;
  for (const std::string start : {"1,2", "here", "1;2;3", "1,2,3,4", "nan,1,2", "4.5,2.5,0"}) {
    options.start = start;
    EXPECT_THAT(errorOf([&] { simulateHall(options); }), testing::HasSubstr("'start'")) << start;
  }
  EXPECT_THAT(errorOf([] { Simulation::load({}); }), testing::HasSubstr("'world'"));
}

TEST(Simulation, AProfileGivesDefaultsThatSingleOptionsOverride) {
  Parameters parameters;
  parameters.set("profile", std::string("bad"));
  parameters.set("odom_axle_ratio", OptionValue(1.01));
  const auto options = SimulationOptions::from(parameters);
  EXPECT_EQ(options.odometry.odom_wheel_noise, 1e-3);
  EXPECT_EQ(options.odometry.odom_axle_ratio, 1.01);
  parameters.set("profile", std::string("perfect"));
  EXPECT_THROW(SimulationOptions::from(parameters), std::invalid_argument);
}

TEST(Simulation, TheLaserSeesPeopleAndFurniture) {
  const auto count = [](const SimulationOptions& options) {
    Simulation simulation = simulateHall(options);
    int shorter = 0;
    while (simulation.time() < 30.0) {
      const Sensed sensed = simulation.step();
      if (!sensed.scan) continue;
      const auto world = makeWorld(hall(), false);
      const Pose2 laser = simulation.truth() * simulation.laserMounts().front();
      for (std::size_t i = 0; i < sensed.scan->ranges.size(); ++i) {
        const double bearing = sensed.scan->angle_min + double(i) * sensed.scan->angle_increment;
        const double expected = world->range(laser * Pose2{0.0, 0.0, bearing}, 80.0);
        shorter += sensed.scan->ranges[i] < expected - 0.3;
      }
    }
    return shorter;
  };
  SimulationOptions options;
  options.laser.laser_short = options.laser.laser_mixed = 0.0;
  EXPECT_EQ(count(options), 0);
  options.furniture = true;
  const int with_furniture = count(options);
  EXPECT_GT(with_furniture, 300);
  options.people = 3;
  EXPECT_GT(count(options), with_furniture + 300);
}

}  // namespace
}  // namespace adaptive_localization
