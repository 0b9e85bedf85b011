// SPDX-License-Identifier: BSD-3-Clause
// Scans in a room whose map has thick walls: what a laser sees is on their faces, as where they
// were painted from a plan, or in their middles, as where scans were laid over each other
// inexactly.
#include <gmock/gmock.h>

#include "match/scan_matcher.hpp"
#include "support/pose_matchers.hpp"
#include "support/thick_room.hpp"

namespace adaptive_localization {
namespace {

/// How far off matches are at last, while a robot goes about the room and turns, m.
double lastErrorOf(const std::shared_ptr<const OccupancyGrid>& map,
                   const std::shared_ptr<const OccupancyGrid>& world) {
  SurfaceMaps surfaces(map, MapQuality(*map));
  const ScanMatcher matcher = makeScanMatcher(MatchOptions{}, surfaces);
  Pose2 truth{1.5, 1.5, 0.3};
  double error = 0.0;
  for (int i = 0; i < 10; ++i) {
    truth = truth * Pose2{0.1, 0.0, 0.2};
    const Scan scan = ToyLaser{181, -kPi / 2, kPi / 2, 12.0}.observe(world, truth).scan;
    const Match match = matcher.match(truth * Pose2{0.05, -0.05, 0.02}, scan);
    EXPECT_TRUE(match.isGood());
    error = distance(match.T_map_base, truth);
  }
  return error;
}

TEST(ThickWalls, AreMatchedWhereScansFit) {
  const auto thick = roomWithWalls(0, 7);
  EXPECT_LT(lastErrorOf(thick, roomWithWalls(0, 1)), 0.03) << "faces";
  EXPECT_LT(lastErrorOf(thick, roomWithWalls(3, 4)), 0.03) << "middles";
}

TEST(ThickWalls, ThinOnesAreMatchedAsEver) {
  EXPECT_LT(lastErrorOf(roomWithWalls(0, 1), roomWithWalls(0, 1)), 0.03);
}

}  // namespace
}  // namespace adaptive_localization
