// SPDX-License-Identifier: BSD-3-Clause
#include "ser/energy_grid.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>
#include <tuple>

#include "ser_toys.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Scan scanAt(const MapPtr& map, const Pose2& pose) {
  return toScan(kHalfCircle.read(map, pose));
}

/// By the formula, with ranges by exact traversal: 30 beams, 6 degrees apart.
double exactEnergy(const MapPtr& map, const Pose2& pose) {
  double sum = 0.0;
  for (int i = 0; i < 30; ++i) {
    const double bearing = -kPi / 2 + i * 3 * kDirectionStep;
    const double z = RayCaster(map).range({pose.x, pose.y, pose.theta + bearing}, 10.0);
    sum += 1.0 - z / 10.0;
  }
  return sum / 30.0;
}

TEST(EnergyGrid, HoldsAllHeadingsOfAllFreeCellsSortedByEnergy) {
  const MapPtr map = smallRoom();
  const auto grid = gridOf(map);
  ASSERT_EQ(grid->size(), 18 * map->countFree());
  std::set<std::tuple<int, int, int>> poses;
  for (std::size_t i = 0; i < grid->size(); ++i) {
    ASSERT_GE(grid->energy(i), 0.0);
    ASSERT_LE(grid->energy(i), 1.0);
    ASSERT_LE(grid->energy(i), grid->energy(i > 0 ? i - 1 : 0));
    const Pose2 pose = grid->pose(i);
    const Cell cell = map->lattice().cellAt({pose.x, pose.y});
    ASSERT_TRUE(map->isFree(cell));
    poses.insert({cell.x, cell.y, static_cast<int>(std::lround(pose.theta / (kPi / 90)))});
  }
  EXPECT_EQ(poses.size(), grid->size()) << "no pose twice";
}

TEST(EnergyGrid, HasTheEnergiesOfExactRayCasting) {
  for (const Pose2& origin : {Pose2{}, Pose2{5.0, -1.0, 1.0}}) {
    const MapPtr map = std::make_shared<const OccupancyGrid>(
        Lattice(maze()->lattice().width(), maze()->lattice().height(), 0.05, origin),
        maze()->cells());
    const auto grid = gridOf(map);
    Rng rng(1);
    constexpr int kPoses = 5000;
    int off = 0;
    for (int n = 0; n < kPoses; ++n) {
      const std::size_t i = rng.below(grid->size());
      off += std::abs(exactEnergy(map, grid->pose(i)) - grid->energy(i)) > 0.01 ? 1 : 0;
    }
    EXPECT_LE(off, kPoses / 100);
  }
}

TEST(EnergyGrid, FindsAScansOwnPoseAmongTheSimilar) {
  const MapPtr map = maze();
  const auto grid = gridOf(map);
  Rng rng(2);
  constexpr int kPoses = 1000;
  int found = 0;
  for (int n = 0; n < kPoses; ++n) {
    const std::size_t i = rng.below(grid->size());
    const auto energy = grid->energyOf(scanAt(map, grid->pose(i)));
    ASSERT_TRUE(energy);
    EXPECT_EQ(energy->delta, 0.02);
    const auto region = grid->similarTo(*energy);
    found += region.begin <= i && i < region.end ? 1 : 0;
  }
  EXPECT_GE(found, kPoses * 999 / 1000);
}

TEST(EnergyGrid, IsZeroWhereNothingIsSeenAndForAScanOfNoReturns) {
  const MapPtr map = toyWorld(Art(20, std::string(20, '.')), 0.1);
  const auto grid = gridOf(map);
  EXPECT_EQ(grid->energy(0), 0.0);
  EXPECT_EQ(grid->energy(grid->size() - 1), 0.0);
  const auto energy = grid->energyOf(scanAt(map, {1.0, 1.0, 0.0}));
  ASSERT_TRUE(energy);
  EXPECT_EQ(energy->value, 0.0);
  EXPECT_EQ(grid->similarTo(*energy).size(), grid->size());
}

TEST(EnergyGrid, LeavesInvalidBeamsOutAndTrustsTheRestLess) {
  const MapPtr map = smallRoom();
  const auto grid = gridOf(map);
  LaserScan message = kHalfCircle.read(map, {1.5, 1.0, 0.3});
  for (float& range : message.ranges) range = 2.5F;
  for (std::size_t i = 0; i < 15; ++i) message.ranges[3 * i] = std::nanf("");  // half of 30
  const auto energy = grid->energyOf(toScan(message));
  ASSERT_TRUE(energy);
  EXPECT_NEAR(energy->value, 0.75, 0.002);  // half a step of 10 m / 255
  EXPECT_NEAR(energy->delta, 0.02 + 0.25, 1e-9);
}

TEST(EnergyGrid, UsesTheBeamsThatACoarseLaserHas) {
  const MapPtr map = smallRoom();
  for (const int beams : {2, 5, 10, 19, 31}) {  // whole directions apart, but for the last
    LaserScan message = ToyLaser{beams, -kPi / 2, kPi / 2, 20.0}.read(map, {1.5, 1.0, 0.3});
    const auto grid = gridOf(map, geometryOf(toScan(message), 10.0));
    const auto energy = grid->energyOf(toScan(message));
    ASSERT_TRUE(energy);
    EXPECT_EQ(energy->delta, 0.02) << beams;
    message.ranges[1] = std::nanf("");
    const double masked = 1.0 / std::min(beams, 30);
    EXPECT_NEAR(grid->energyOf(toScan(message))->delta, 0.02 + 0.5 * masked, 1e-9) << beams;
  }
}

TEST(EnergyGrid, KnowsNoEnergyOfAScanThatTellsNothing) {
  const MapPtr map = smallRoom();
  const auto grid = gridOf(map);
  EXPECT_FALSE(grid->energyOf(Scan{}));
  LaserScan message = kHalfCircle.read(map, {1.5, 1.0, 0.3});
  for (float& range : message.ranges) range = std::nanf("");
  EXPECT_FALSE(grid->energyOf(toScan(message)));
}

TEST(EnergyGrid, PlacesTheBaseOfALaserThatSitsElsewhere) {
  const Pose2 origin{4.0, -3.0, 0.5};
  const MapPtr map = smallRoom(origin);
  const LaserMount mount = LaserMount::level({0.2, -0.1, 0.7});
  Scan scan = toScan(kHalfCircle.read(map, origin * Pose2{1.5, 1.0, 0.0}), mount, ScanOptions{});
  const auto grid = gridOf(map, geometryOf(scan, 10.0));
  Rng rng(3);
  int off = 0;
  for (int n = 0; n < 500; ++n) {
    const std::size_t i = rng.below(grid->size());
    const Pose2 sensor = grid->pose(i) * Pose2{0.2, -0.1, 0.7};
    const Eigen::Vector2d in_cell = 0.2 * Eigen::Vector2d(0.5, 0.5);  // centres of 0.2 m
    const Pose2 local = map->lattice().toLattice(sensor);
    EXPECT_NEAR(std::remainder(local.x - in_cell.x(), 0.2), 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(local.y - in_cell.y(), 0.2), 0.0, 1e-9);
    off += std::abs(exactEnergy(map, sensor) - grid->energy(i)) > 0.02 ? 1 : 0;
  }
  EXPECT_LE(off, 10);
}

TEST(EnergyGrid, MovesAPoseWithinItsCellAndHeadingStep) {
  const auto grid = gridOf(smallRoom({1.0, 2.0, 0.3}));
  const Pose2 middle = grid->pose(7);
  const Pose2 moved = grid->pose(7, {0.5, -0.5, 0.5});
  EXPECT_NEAR(distance(middle, moved), 0.1 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(wrapAngle(moved.theta - middle.theta), kPi / 18, 1e-9);
  EXPECT_THAT(grid->pose(7, Eigen::Vector3d::Zero()), PoseNear(middle, 1e-12, 1e-12));
}

TEST(EnergyGrid, NeedsOneHeadingForALaserThatSeesAllRound) {
  ScanGeometry ring = halfCircle();
  ring.count = kDirections;
  const MapPtr map = smallRoom();
  const auto grid = gridOf(map, ring);
  EXPECT_EQ(grid->orientations(), 1);
  EXPECT_EQ(grid->size(), map->countFree());
  ring.spacing = kPi / 18;  // 36 beams: between them it sees something else
  EXPECT_EQ(gridOf(map, ring)->orientations(), 18);
}

TEST(EnergyGrid, TakesOtherNumbersOfBeamsAndHeadings) {
  const MapPtr map = smallRoom();
  for (const auto& [beams, orientations] : {std::pair{1, 1}, {7, 5}, {91, 180}, {180, 7}}) {
    EnergyGridOptions options;
    options.energy_beams = beams;
    options.energy_orientations = orientations;
    const auto grid = gridOf(map, halfCircle(), options);
    EXPECT_EQ(grid->size(), map->countFree() * static_cast<std::size_t>(orientations));
    const std::size_t i = grid->size() / 2;
    const auto energy = grid->energyOf(scanAt(map, grid->pose(i)));
    ASSERT_TRUE(energy);
    EXPECT_NEAR(energy->value, grid->energy(i), 0.03) << beams << " " << orientations;
  }
}

TEST(EnergyGrid, UsesCellsAsFarApartAsAskedFor) {
  EnergyGridOptions options;
  const auto spacing = [&options](double resolution, double pitch) {
    options.energy_grid_pitch = pitch;
    return gridOf(maze(resolution), halfCircle(), options)->ranges().spacing();
  };
  EXPECT_EQ(spacing(0.05, 0.1), 2);
  EXPECT_EQ(spacing(double{0.05F}, 0.1), 2) << "as a message has it";
  EXPECT_EQ(spacing(0.05, 0.0), 1);
  EXPECT_EQ(spacing(0.05, 0.19), 3);
  EXPECT_EQ(spacing(0.15, 0.1), 1);
  EXPECT_EQ(spacing(0.05, 10.0), 73) << "farther apart there is no free cell";
}

TEST(EnergyGrid, UsesFewerCellsWhereMemoryIsShort) {
  const MapPtr map = maze();
  EnergyGridOptions options;
  options.energy_grid_max_memory = 1.0;  // of 2.8 MB
  const auto grid = gridOf(map, halfCircle(), options);
  EXPECT_EQ(grid->ranges().spacing(), 2);
  EXPECT_LE(grid->bytes(), 1000000U);
  Rng rng(4);
  for (int n = 0; n < 100; ++n) {  // jitter fills the gaps between cells
    const Pose2 pose = grid->pose(rng.below(grid->size()), {0.5, 0.0, 0.0});
    EXPECT_TRUE(isFinite(pose));
  }
  const Pose2 middle = grid->pose(7);
  EXPECT_NEAR(distance(middle, grid->pose(7, {0.5, 0.0, 0.0})), 0.05, 1e-9);
}

TEST(EnergyGrid, ComplainsAboutAMapWithoutFreeCells) {
  EXPECT_THAT(
      [] {
        gridOf(toyWorld({"#?", "##"}, 0.1));
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("no free cell")));
}

}  // namespace
}  // namespace adaptive_localization
