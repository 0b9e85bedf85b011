// SPDX-License-Identifier: BSD-3-Clause
#include "ser/places.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "ser_toys.hpp"
#include "support/pose_matchers.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Optional;
using testing::ThrowsMessage;

const Pose2 kTruth{2.53, 3.51, 0.4};

Places placesOf(const MapPtr& map, Places::Build build = Places::Build::kAtOnce,
                const EnergyGridOptions& options = {}) {
  return {map, std::make_shared<const DistanceField>(*map), options, {}, build};
}

Scan scanOf(int beams, double first_degrees = -90.0, double step_degrees = 1.0,
            const LaserMount& mount = {}) {
  const double degree = kPi / 180.0;
  ToyLaser laser;
  laser.beams = beams;
  laser.angle_min = first_degrees * degree;
  laser.angle_max = (first_degrees + step_degrees * (beams - 1)) * degree;
  ScanOptions options;
  options.laser_max_beams = 400;
  return toScan(laser.read(asymmetricWorld(), kTruth), mount, options);
}

/// Asks every 5 ms, for 10 s at the most.
std::shared_ptr<const EnergyGrid> waitForGrid(Places& places, const Scan& scan) {
  for (int i = 0; i < 2000; ++i) {
    if (auto grid = places.energyGrid(scan)) return grid;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return nullptr;
}

/// A hall so large that its grid cannot be ready before it is stopped.
TEST(Places, StopBuildingWhatIsNoLongerWanted) {
  const Lattice lattice(1500, 1500, 0.05, {});
  const auto hall = std::make_shared<const OccupancyGrid>(
      lattice, std::vector<std::int8_t>(lattice.size(), OccupancyGrid::kFree));
  EnergyGridOptions options;
  options.energy_grid_max_memory = 1e6;
  Places places = placesOf(hall, Places::Build::kInBackground, options);
  EXPECT_FALSE(places.isReadyFor(scanOf(181)));
  places.stopBuilding();
  while (!places.isReadyFor(scanOf(181))) std::this_thread::yield();
  EXPECT_FALSE(places.newestGrid());
  EXPECT_THAT(places.takeWarnings(), ElementsAre(HasSubstr("stopped")));
}

TEST(Places, KeepTheGridOfALaserThatAlternates) {
  Places places = placesOf(asymmetricWorld());
  const auto grid = places.energyGrid(scanOf(181));
  ASSERT_TRUE(grid);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(places.energyGrid(scanOf(181)), grid);
    EXPECT_EQ(places.energyGrid(scanOf(180)), grid);            // one beam short
    EXPECT_EQ(places.energyGrid(scanOf(180, -89.5)), grid);     // interlaced
    EXPECT_EQ(places.energyGrid(scanOf(361, -90, 0.5)), grid);  // twice as dense
  }
}

TEST(Places, MakeAGridForEachOfSeveralLasers) {
  Places places = placesOf(asymmetricWorld());
  const auto front = places.energyGrid(scanOf(181));
  const Scan behind = scanOf(181, -90, 1, LaserMount::level({-0.2, 0.0, kPi}));
  const auto rear = places.energyGrid(behind);
  ASSERT_TRUE(front && rear);
  EXPECT_NE(front, rear);
  EXPECT_EQ(&front->ranges(), &rear->ranges()) << "one table for both";
  EXPECT_EQ(rear->geometry().position, Eigen::Vector2d(-0.2, 0.0));
  EXPECT_EQ(places.energyGrid(scanOf(181)), front);
  EXPECT_EQ(places.energyGrid(behind), rear);
}

TEST(Places, MakeAnotherGridForAnotherLaser) {
  Places places = placesOf(asymmetricWorld());
  const auto first = places.energyGrid(scanOf(181));
  EXPECT_NE(places.energyGrid(scanOf(271, -135)), first);
  EXPECT_NE(places.energyGrid(scanOf(181, -80)), first);
  Scan short_sighted = scanOf(181);
  short_sighted.max_range = 8.0;
  const auto third = places.energyGrid(short_sighted);
  EXPECT_EQ(third->ranges().maxRange(), 8.0);
  EXPECT_EQ(places.energyGrid(scanOf(360, -180))->orientations(), 1);
}

TEST(Places, RememberAFewGridsOnly) {
  Places places = placesOf(smallRoom());
  const auto first = places.energyGrid(scanOf(181));
  for (int beams = 20; beams < 180; beams += 10) {
    EXPECT_EQ(places.energyGrid(scanOf(beams))->geometry().count, (beams + 1) / 2);
  }
  EXPECT_NE(places.energyGrid(scanOf(181)), first);
}

TEST(Places, AreWhereTheScanWasTaken) {
  Places places = placesOf(asymmetricWorld());
  const Observations seen{1.0, scanOf(181)};
  const auto found = places.search(seen);
  ASSERT_TRUE(found && !found->empty());
  EXPECT_THAT(found->front().T_map_base, PoseNear(kTruth, 0.05, 0.03));
  places.beginUpdate({}, 0);
  EXPECT_TRUE(places.search(seen)) << "remembered, no work";
  places.beginUpdate({}, kUnlimitedWork);
  Observations other{1.0, toScan(kHalfCircle.read(asymmetricWorld(), {1.0, 1.0, 0.3}))};
  const auto others = places.search(other);
  ASSERT_TRUE(others && !others->empty());
  EXPECT_THAT(others->front().T_map_base, PoseNear(Pose2{1.0, 1.0, 0.3}, 0.05, 0.03));
}

/// The same as at once, and no update does more than it may.
TEST(Places, AreSearchedForInParts) {
  constexpr SearchWork kWork = 200;
  const Observations seen{1.0, scanOf(181)};
  const auto at_once = placesOf(asymmetricWorld()).search(seen);
  Places in_parts = placesOf(asymmetricWorld());
  std::optional<std::vector<Place>> answer;
  int updates = 0;
  for (; !answer && updates < 1000; ++updates) {
    in_parts.beginUpdate({5.0, 2.0, 0.7}, kWork);
    answer = in_parts.search(seen);
  }
  EXPECT_GT(updates, 3);
  ASSERT_TRUE(answer && at_once);
  EXPECT_FALSE(in_parts.askedBefore(seen)) << "by the same scan";
  ASSERT_EQ(answer->size(), at_once->size());
  for (std::size_t i = 0; i < answer->size(); ++i) {
    EXPECT_THAT((*answer)[i].T_map_base, PoseNear((*at_once)[i].T_map_base, 1e-12, 1e-12));
    EXPECT_EQ((*answer)[i].error, (*at_once)[i].error);
  }
}

TEST(Places, AreSearchedForBetweenUpdatesToo) {
  const Observations seen{1.0, scanOf(181)};
  const auto at_once = placesOf(asymmetricWorld()).search(seen);
  Places places = placesOf(asymmetricWorld());
  places.searchOn(kUnlimitedWork);  // nothing was asked for
  places.beginUpdate({}, 1);
  EXPECT_FALSE(places.search(seen));
  places.searchOn(1);
  EXPECT_FALSE(places.search(seen));
  places.searchOn(kUnlimitedWork);
  const SearchWork left = places.workLeft();
  const auto answer = places.search(seen);
  EXPECT_EQ(places.workLeft(), left) << "of the update";
  ASSERT_TRUE(answer && at_once);
  ASSERT_EQ(answer->size(), at_once->size());
  EXPECT_THAT(answer->front().T_map_base, PoseNear(at_once->front().T_map_base, 1e-12, 1e-12));
}

/// The answer to another scan tells by which one was asked.
TEST(Places, AreAskedForBeforeTheAnswerIsWanted) {
  Places places = placesOf(asymmetricWorld());
  const Observations asked{1.0, scanOf(181)}, later{2.0, scanOf(181)};
  places.beginUpdate({}, kUnlimitedWork);
  places.ask(asked);
  EXPECT_EQ(places.workLeft(), kUnlimitedWork);
  places.ask(later);  // of no effect
  places.beginUpdate({0.1, 0.0, 0.0}, kUnlimitedWork);
  ASSERT_TRUE(places.search(later));
  ASSERT_NE(places.askedBefore(later), nullptr);
  EXPECT_EQ(places.askedBefore(later)->observations.stamp, asked.stamp);
  EXPECT_NEAR(places.askedBefore(later)->motion.x, 0.1, 1e-12);
}

/// What the first scan began, the last one judges, from where the robot is by then.
TEST(Places, RideOnTheOdometryWhileTheyAreSearchedFor) {
  const auto searchAlong = [](const Pose2& by_odometry, const Pose2& in_truth) {
    Places places = placesOf(asymmetricWorld());
    places.beginUpdate({}, 1);
    EXPECT_FALSE(places.search({1.0, scanOf(181)}));
    places.beginUpdate(by_odometry, kUnlimitedWork);
    ToyLaser laser = kHalfCircle;
    const Observations now{2.0, toScan(laser.read(asymmetricWorld(), in_truth))};
    const auto found = places.search(now);
    const Places::Asked* asked = places.askedBefore(now);
    EXPECT_TRUE(asked);
    if (asked) {
      EXPECT_EQ(asked->observations.stamp, 1.0);
      EXPECT_THAT(asked->motion, PoseNear(by_odometry, 1e-12, 1e-12));
      EXPECT_THAT(asked->places.front().T_map_base, PoseNear(kTruth, 0.05, 0.03));
    }
    EXPECT_FALSE(places.askedBefore({3.0, Scan{}})) << "that was not answered";
    return found.value();
  };
  const Pose2 motion{0.3, 0.0, 0.2};
  const auto driven = searchAlong(motion, kTruth * motion);
  ASSERT_FALSE(driven.empty());
  EXPECT_THAT(driven.front().T_map_base, PoseNear(kTruth * motion, 0.05, 0.03));
  EXPECT_LT(driven.front().error, 0.05);
  const auto carried = searchAlong(motion, {1.0, 1.0, 0.3});
  for (const Place& place : carried) EXPECT_GT(place.error, 0.1) << "it is at none of them";
}

TEST(Places, ForgetAQuestionThatTheRobotLeftBehind) {
  Places places = placesOf(asymmetricWorld());
  places.beginUpdate({}, 1);
  EXPECT_FALSE(places.search({1.0, scanOf(181)}));
  places.beginUpdate({9.0, 0.0, 0.0}, kUnlimitedWork);
  const auto found = places.search({2.0, scanOf(181)});
  ASSERT_TRUE(found && !found->empty());
  EXPECT_THAT(found->front().T_map_base, PoseNear(kTruth, 0.05, 0.03)) << "asked anew, from here";
}

TEST(Places, AreNoneForScansThatTellNothing) {
  Places places = placesOf(asymmetricWorld());
  for (const float range : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    LaserScan message = kHalfCircle.read(asymmetricWorld(), kTruth);
    std::fill(message.ranges.begin(), message.ranges.end(), range);
    const Observations nothing{2.0, toScan(message)};
    EXPECT_THAT(places.search(nothing), Optional(IsEmpty()));
  }
}

TEST(Places, HaveNoGridWhileItIsMadeInTheBackground) {
  Places places = placesOf(asymmetricWorld(), Places::Build::kInBackground);
  const Scan scan = scanOf(181);
  EXPECT_EQ(places.energyGrid(scan), nullptr);
  EXPECT_THAT(places.search({0.0, scan}), Optional(IsEmpty()));
  const auto grid = waitForGrid(places, scan);
  ASSERT_TRUE(grid);
  EXPECT_EQ(places.energyGrid(scanOf(180)), grid);
  EXPECT_THAT(places.search({0.0, scan}), Optional(Not(IsEmpty())));

  // another laser: made once, while the first goes on
  const Scan wide = scanOf(271, -135);
  EXPECT_EQ(places.energyGrid(wide), nullptr);
  EXPECT_EQ(places.energyGrid(scan), grid);
  EXPECT_NE(waitForGrid(places, wide), grid);
}

TEST(Places, KeepTheirGridFromStartToStart) {
  const TempFolder folder;
  EnergyGridOptions options;
  options.cache_dir = folder.file("cache");
  for (const bool expected : {false, true}) {
    Places places = placesOf(smallRoom(), Places::Build::kInBackground, options);
    ASSERT_TRUE(waitForGrid(places, scanOf(181)));
    EXPECT_EQ(places.isNewestFromCache(), expected);
    EXPECT_THAT(places.takeWarnings(), IsEmpty());
  }
}

TEST(Places, MayGoWhileAGridIsBeingMade) {
  for (int i = 0; i < 20; ++i) {
    Places places = placesOf(maze(), Places::Build::kInBackground);
    EXPECT_EQ(places.energyGrid(scanOf(181)), nullptr);
  }
}

TEST(Places, SayNothingOfAGridAsCoarseAsAskedFor) {
  EnergyGridOptions options;
  options.energy_grid_pitch = 0.1;
  Places places = placesOf(asymmetricWorld(), Places::Build::kAtOnce, options);
  EXPECT_EQ(places.energyGrid(scanOf(181))->ranges().spacing(), 2);
  EXPECT_THAT(places.takeWarnings(), IsEmpty());
}

TEST(Places, SayOnceThatTheGridIsCoarserThanAskedFor) {
  EnergyGridOptions options;
  options.energy_grid_max_memory = 2.0;
  Places places = placesOf(asymmetricWorld(), Places::Build::kAtOnce, options);
  EXPECT_THAT(places.takeWarnings(), IsEmpty());
  const auto grid = places.energyGrid(scanOf(181));
  EXPECT_GT(grid->ranges().spacing(), 1);
  EXPECT_THAT(places.takeWarnings(),
              ElementsAre(AllOf(HasSubstr("energy_grid_max_memory"), HasSubstr("2 MB"))));
  places.energyGrid(scanOf(271, -135));
  EXPECT_THAT(places.takeWarnings(), IsEmpty());
  const auto found = places.search({0.0, scanOf(181)});
  ASSERT_TRUE(found && !found->empty());
  EXPECT_THAT(found->front().T_map_base, PoseNear(kTruth, 0.1, 0.05));
}

TEST(Places, SayOnceThatAMapHasNoFreeCellAndKnowNone) {
  const MapPtr map = toyWorld({"#?", "##"}, 0.1);
  for (const auto build : {Places::Build::kAtOnce, Places::Build::kInBackground}) {
    Places places = placesOf(map, build);
    places.energyGrid(scanOf(181));
    while (places.isBuilding()) places.newestGrid();
    EXPECT_EQ(places.energyGrid(scanOf(181)), nullptr);
    EXPECT_THAT(places.search({0.0, scanOf(181)}), Optional(IsEmpty()));
    EXPECT_THAT(places.takeWarnings(), ElementsAre(HasSubstr("no free cell")));
    EXPECT_FALSE(places.isBuilding());
  }
}

}  // namespace
}  // namespace adaptive_localization
