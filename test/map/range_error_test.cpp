// SPDX-License-Identifier: BSD-3-Clause
#include "map/range_error.hpp"

#include <gtest/gtest.h>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kPlace{2.0, 3.0, -0.5};

Scan scanAt(const Pose2& pose, int beams = 181) {
  return ToyLaser{beams, -kPi / 2, kPi / 2, 12.0}.observe(asymmetricWorld(), pose).scan;
}

TEST(RangeError, IsNoughtWhereTheScanWasTaken) {
  const RangeError error(asymmetricWorld());
  EXPECT_NEAR(error.at(kPlace, scanAt(kPlace)).error, 0.0, 1e-5);
  EXPECT_EQ(error.at(kPlace, scanAt(kPlace)).short_share, 0.0);
  EXPECT_GT(error.at({8.0, 1.0, 2.0}, scanAt(kPlace)).error, 0.2);
}

TEST(RangeError, IsTheMeanOfTruncatedDifferences) {
  Scan scan = scanAt(kPlace, 50);
  ASSERT_EQ(scan.hits(), 50);
  scan.range.head(10) += 0.1F;
  scan.range.segment(10, 10) *= 0.1F;  // far too short
  const RangeError::Fit fit = RangeError(asymmetricWorld(), nullptr, 0.5, 0.0).at(kPlace, scan);
  EXPECT_NEAR(fit.error, (10 * 0.1 + 10 * 0.5) / 50.0, 1e-3);
  EXPECT_NEAR(fit.short_share, 0.2, 1e-9);
}

TEST(RangeError, CountsBeamsThatAreTooShortAndThoseThatAreOff) {
  const auto map = toyWorld({"#..........#"}, 0.1, {}, 5);
  Scan scan = ToyLaser{21, -0.1, 0.1, 12.0}.observe(map, {1.0, 0.25, 0.0}).scan;
  scan.range.head(7) -= 0.3F;
  scan.range.tail(2) += 0.8F;  // through the wall
  const auto fit = RangeError(map).at({1.0, 0.25, 0.0}, scan);
  EXPECT_NEAR(fit.short_share, 7.0 / 21.0, 1e-9);
  EXPECT_NEAR(fit.off_share, 9.0 / 21.0, 1e-9);
}

TEST(RangeError, NoReturnsCountAsTheLargestRange) {
  Scan scan;
  scan.max_range = 2.0;
  scan.no_return_bearing = Eigen::ArrayXf::Zero(1);
  const RangeError error(asymmetricWorld());
  const Pose2 before_wall{3.5, 1.0, kPi};  // 3 m from it
  EXPECT_NEAR(error.at(before_wall, scan).error, 0.0, 1e-9);
  EXPECT_NEAR(error.at({2.3, 1.0, kPi}, scan).error, 2.0 - (2.3 - 0.475), 1e-5);
}

TEST(RangeError, AScanWithoutBeamsIsAsBadAsCanBe) {
  EXPECT_EQ(RangeError(asymmetricWorld()).at(kPlace, Scan{}).error, RangeError::kTruncation);
}

TEST(RangeError, ABeamMayEndAnywhereInAWall) {
  const auto map = toyWorld({"..............", "..........####", ".............."}, 0.1, {}, 5);
  const RangeError error(map);
  const RangeError plain(map, nullptr, 0.5, 0.0);
  const Pose2 pose{1.0, 0.75, 0.0};  // the face is 4 m before it
  const auto errorOf = [&](const RangeError& of, double range) {
    return of.at(pose, hitsAt({{range, 0.0}}, 10.0).scan).error;
  };
  EXPECT_NEAR(errorOf(error, 3.9), 0.15, 1e-5);  // surfaces are in the middle of cells
  EXPECT_NEAR(errorOf(error, 4.3), 0.0, 1e-5);
  EXPECT_NEAR(errorOf(error, 4.65), 0.3, 0.051);  // beyond 0.35 m it is rock
  EXPECT_NEAR(errorOf(plain, 4.3), 0.25, 1e-5);
}

TEST(RangeError, LooksThroughWhatTheMapHasWhereTheRobotStands) {
  const Scan scan = scanAt(kPlace);
  const auto world = asymmetricWorld();
  std::vector<std::int8_t> cells = world->cells();
  const Lattice& lattice = world->lattice();
  for (double x = -0.2; x <= 0.2; x += 0.05) {
    for (double y = -0.2; y <= 0.2; y += 0.05) {
      cells[lattice.index(lattice.cellAt({kPlace.x + x, kPlace.y + y}))] = OccupancyGrid::kOccupied;
    }
  }
  const auto cluttered = std::make_shared<const OccupancyGrid>(lattice, cells);
  EXPECT_LT(RangeError(cluttered).at(kPlace, scan).error, 0.01);
  EXPECT_GT(RangeError(cluttered, nullptr, 0.5, 0.0).at(kPlace, scan).error, 0.4);
}

}  // namespace
}  // namespace adaptive_localization
