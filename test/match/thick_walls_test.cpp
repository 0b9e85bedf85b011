// SPDX-License-Identifier: BSD-3-Clause
// Scans in a room whose map has thick walls: what a laser sees is on their faces, as where they
// were painted from a plan, or in their middles, as where scans were laid over each other
// inexactly.
#include <gmock/gmock.h>

#include <algorithm>

#include "adaptive_localization/match/scan_matcher.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// A room of 4 m by 3 m, its walls in the cells that are `from` to before `to` cells behind it.
std::shared_ptr<const OccupancyGrid> roomWithWalls(int from, int to) {
  constexpr int kWidth = 80, kHeight = 60, kMargin = 10;  // cells
  const Lattice lattice(kWidth + 2 * kMargin, kHeight + 2 * kMargin, 0.05, {});
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kFree);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = lattice.cell(i);
    const int beyond_x = std::max(kMargin - 1 - cell.x, cell.x - kMargin - kWidth);
    const int beyond_y = std::max(kMargin - 1 - cell.y, cell.y - kMargin - kHeight);
    const int behind = std::max(beyond_x, beyond_y);
    if (behind >= from && behind < to) cells[i] = OccupancyGrid::kOccupied;
  }
  return std::make_shared<const OccupancyGrid>(lattice, std::move(cells));
}

/// How far off matches are at last, while a robot goes about the room and turns, m.
double lastErrorOf(const OccupancyGrid& map, const std::shared_ptr<const OccupancyGrid>& world) {
  const ScanMatcher matcher = makeScanMatcher(MatchOptions{}, map, MapQuality(map));
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
  EXPECT_LT(lastErrorOf(*thick, roomWithWalls(0, 1)), 0.03) << "faces";
  EXPECT_LT(lastErrorOf(*thick, roomWithWalls(3, 4)), 0.03) << "middles";
}

TEST(ThickWalls, ThinOnesAreMatchedAsEver) {
  EXPECT_LT(lastErrorOf(*roomWithWalls(0, 1), roomWithWalls(0, 1)), 0.03);
}

}  // namespace
}  // namespace adaptive_localization
