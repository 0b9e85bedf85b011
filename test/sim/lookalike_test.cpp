// SPDX-License-Identifier: BSD-3-Clause
// The worlds in which many places look alike.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "adaptive_localization/map/map_io.hpp"
#include "sim/rasterize.hpp"
#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

std::shared_ptr<const World> worldOf(const std::string& name) {
  return makeWorld(loadFloorPlan(worldFile(name)), false);
}

/// How many of 180 beams all round see the same from two poses.
int alike(const World& world, const Pose2& a, const Pose2& b, double max_range = 80.0) {
  int count = 0;
  for (int i = 0; i < 180; ++i) {
    const Pose2 ray{0.0, 0.0, 2.0 * kPi * i / 180.0};
    count += std::abs(world.range(a * ray, max_range) - world.range(b * ray, max_range)) < 0.02;
  }
  return count;
}

TEST(Lookalike, MapsAreThoseThatTheirPlansMake) {
  const auto expect = [](const std::string& name, const std::string& plan, double resolution) {
    const OccupancyGrid committed = loadMap(mapFile(name));
    const OccupancyGrid drawn = rasterize(loadFloorPlan(worldFile(plan)), resolution);
    EXPECT_EQ(committed.cells(), drawn.cells()) << name;
    EXPECT_NEAR(committed.lattice().origin().x, drawn.lattice().origin().x, 1e-9) << name;
    EXPECT_NEAR(committed.lattice().origin().y, drawn.lattice().origin().y, 1e-9) << name;
  };
  expect("office", "office", 0.05);
  expect("office_moved", "office", 0.05);
  expect("warehouse", "warehouse", 0.05);
  expect("hall", "hall", 0.1);
}

TEST(Lookalike, TheOfficesRoomsAreEqual) {
  const auto office = worldOf("office");
  const Pose2 first{4.4, 2.0, 0.3}, turned = Pose2{8.8, 10.8, kPi} * first;
  for (int room = 0; room < 5; ++room) {
    for (const double corridor : {0.0, 10.8}) {
      const Pose2 shift{4.0 * room, corridor, 0.0};
      EXPECT_GE(alike(*office, first, shift * first), 165) << "but for what the door shows";
      EXPECT_GE(alike(*office, first, shift * turned), 165);
    }
  }
}

TEST(Lookalike, InEverySecondRoomOfTheOfficeDesksWereMoved) {
  const auto office = worldOf("office"), moved = worldOf("office_moved");
  int changed = 0;
  for (int room = 0; room < 5; ++room) {
    for (const double y : {2.0, 8.8, 12.8, 19.6}) {
      const Pose2 here{4.4 + 4.0 * room, y, 0.0};
      int same = 0;
      for (int i = 0; i < 180; ++i) {
        const Pose2 ray = here * Pose2{0.0, 0.0, 2.0 * kPi * i / 180.0};
        same += std::abs(office->range(ray, 80.0) - moved->range(ray, 80.0)) < 0.02;
      }
      changed += same < 150;
      EXPECT_GT(same, 60) << "walls and cupboard stay";
    }
  }
  EXPECT_EQ(changed, 10);
}

TEST(Lookalike, TheWarehousesAislesAreEqual) {
  const auto warehouse = worldOf("warehouse");
  const Pose2 first{15.5, 4.3, 0.2};
  for (int aisle = 1; aisle < 6; ++aisle) {
    EXPECT_GE(alike(*warehouse, first, Pose2{0.0, 3.2 * aisle, 0.0} * first), 170) << aisle;
  }
}

TEST(Lookalike, TheHallsColumnsAreEqualToALaserThatDoesNotSeeFar) {
  const auto hall = worldOf("hall");
  const Pose2 first{17.0, 16.0, 0.2};
  for (const Pose2& shift : {Pose2{10.0, 0.0, 0.0}, Pose2{20.0, 0.0, 0.0}, Pose2{10.0, 8.0, 0.0}}) {
    const bool is_column = shift.y == 0.0;
    EXPECT_EQ(alike(*hall, first, shift * first, 8.0) == 180, is_column);
  }
  EXPECT_LT(alike(*hall, first, Pose2{10.0, 0.0, 0.0} * first), 150) << "an LMS-291 sees the walls";
}

TEST(Lookalike, WorldsAreOfAllSizes) {
  const auto area = [](const std::string& name, double resolution) {
    const auto free = rasterize(loadFloorPlan(worldFile(name)), resolution).countFree();
    return static_cast<double>(free) * resolution * resolution;
  };
  EXPECT_NEAR(area("office", 0.05), 400.0, 40.0);
  EXPECT_NEAR(area("office_moved", 0.05), area("office", 0.05), 2.0);
  EXPECT_NEAR(area("warehouse", 0.05), 600.0, 40.0);
  EXPECT_NEAR(area("hall", 0.1), 2400.0, 40.0);
}

}  // namespace
}  // namespace adaptive_localization
