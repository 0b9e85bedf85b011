// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/range_objective.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "adaptive_localization/core/rng.hpp"
#include "map/segment_index.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr double kMaxRange = 10.0;

Eigen::ArrayXXd one(const Pose2& pose) {
  Eigen::ArrayXXd positions(1, 3);
  positions << pose.x, pose.y, pose.theta;
  return positions;
}

double costAt(const Objective& objective, const Pose2& pose) {
  Eigen::ArrayXd cost(1);
  objective.evaluate(one(pose), cost);
  return cost[0];
}

RangeObjectiveOptions optionsWith(const std::string& error) {
  RangeObjectiveOptions options;
  options.swarm_error = error;
  return options;
}

TableObjective tableOf(const OccupancyGrid& map, const Scan& scan,
                       const RangeObjectiveOptions& options = {}) {
  return {options, scan,
          std::make_shared<const RangeRows>(std::make_shared<const RangeTable>(map, kMaxRange))};
}

}  // namespace

TEST(RangeObjective, IsLeastWhereTheScanWasTaken) {
  const auto map = asymmetricWorld();
  const Pose2 truth{2.52, 1.02, 0.3};
  const Scan scan = ToyLaser{61}.observe(map, truth).scan;
  for (const std::string error : {"truncated", "relative"}) {
    const CastObjective cast(optionsWith(error), scan, kMaxRange, map, castOverCells(map));
    const TableObjective table = tableOf(*map, scan, optionsWith(error));
    EXPECT_LT(costAt(cast, truth), 1e-5) << error;
    EXPECT_LT(costAt(table, truth), 0.06) << error;
    for (const Pose2& wrong : {Pose2{2.9, 1.02, 0.3}, Pose2{2.52, 1.02, 0.8}, Pose2{7, 4, 0.3}}) {
      EXPECT_GT(costAt(cast, wrong), 0.08) << error;
      EXPECT_GT(costAt(table, wrong), 0.08) << error;
    }
  }
}

/// A room of 4 m by 3 m, by its walls and by a map with cells of 0.1 m: the walls tell places apart
/// that are of one cell.
TEST(RangeObjective, RaysMayBeCastOverTheWallsOfAPlan) {
  const auto map = toyWorld(Art(32, std::string(42, '.')), 0.1);
  const SegmentIndex walls({{{0.0, 0.0}, {4.0, 0.0}},
                            {{4.0, 0.0}, {4.0, 3.0}},
                            {{4.0, 3.0}, {0.0, 3.0}},
                            {{0.0, 3.0}, {0.0, 0.0}}});
  const RayCast cast = [&](const Pose2& ray, double most) { return walls.range(ray, most); };
  const Pose2 truth{1.234, 1.678, 0.4321};
  std::vector<Eigen::Vector2d> hits;
  for (int i = -90; i <= 90; i += 3) {
    const double bearing = i * kPi / 180.0;
    const double range = cast({truth.x, truth.y, truth.theta + bearing}, kMaxRange);
    hits.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  const Scan scan = hitsAt(hits, kMaxRange).scan;
  const CastObjective objective({}, scan, kMaxRange, map, cast);
  EXPECT_LT(costAt(objective, truth), 1e-6);
  EXPECT_NEAR(costAt(objective, truth * Pose2{0.003, 0.0, 0.0}), 0.003, 0.0015);
}

TEST(RangeObjective, TheTableSaysWhatRayCastingSays) {
  for (const Pose2& origin : {Pose2{}, Pose2{-3.0, 2.0, 0.7}}) {
    const auto map = asymmetricWorld(origin);
    const Lattice& lattice = map->lattice();
    const Scan scan = ToyLaser{31}.observe(map, origin * Pose2{3.0, 1.0, 0.3}).scan;
    const CastObjective cast({}, scan, kMaxRange, map, castOverCells(map));
    const TableObjective table = tableOf(*map, scan);
    Rng rng(1);
    double difference = 0.0;
    int poses = 0;
    while (poses < 300) {
      const Eigen::Vector2d centre = lattice.centre(lattice.cell(rng.below(lattice.size())));
      // directions of the table
      const double heading = origin.theta + kDirectionStep * static_cast<double>(rng.below(180));
      const Pose2 pose{centre.x(), centre.y(), wrapAngle(heading)};
      if (!map->isFree(lattice.cellAt(centre))) {
        ASSERT_EQ(costAt(table, pose), table.worst());
        ASSERT_EQ(costAt(cast, pose), cast.worst());
        continue;
      }
      difference += std::abs(costAt(cast, pose) - costAt(table, pose));
      ++poses;
    }
    EXPECT_LT(difference / poses, 0.02);
  }
}

TEST(RangeObjective, IsTheMeanOfWhatIsWrong) {
  const auto map = asymmetricWorld();
  const Pose2 pose{1.0, 1.0, 0.0};
  Scan scan = ToyLaser{3}.observe(map, pose).scan;
  ASSERT_EQ(scan.hits(), 3);
  const float right = scan.range[1];
  scan.range[1] = right + 0.2F;  // straight ahead
  EXPECT_NEAR(costAt(CastObjective({}, scan, kMaxRange, map, castOverCells(map)), pose), 0.2 / 3,
              1e-5);
  const CastObjective relative(optionsWith("relative"), scan, kMaxRange, map, castOverCells(map));
  EXPECT_NEAR(costAt(relative, pose), 0.2 / (static_cast<double>(right) + 0.2) / 3, 1e-5);
  scan.range[1] = right - 1.0F;
  EXPECT_NEAR(costAt(CastObjective({}, scan, kMaxRange, map, castOverCells(map)), pose), 0.25 / 3,
              1e-5);
  scan.range[1] = 0.0F;  // would divide by zero
  const CastObjective near_zero(optionsWith("relative"), scan, kMaxRange, map, castOverCells(map));
  EXPECT_NEAR(costAt(near_zero, pose), 1.0 / 3, 1e-5);
}

TEST(RangeObjective, LeavesOutWhatIsNoNumberAndIsZeroWithoutBeams) {
  const auto map = asymmetricWorld();
  Scan scan = ToyLaser{31}.observe(map, {1.0, 1.0, 0.0}).scan;
  scan.range[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_LT(costAt(CastObjective({}, scan, kMaxRange, map, castOverCells(map)), {1.0, 1.0, 0.0}),
            1e-5);
  const CastObjective empty({}, Scan{}, kMaxRange, map, castOverCells(map));
  EXPECT_TRUE(empty.isEmpty());
  EXPECT_EQ(costAt(empty, {1.0, 1.0, 0.0}), 0.0);
}

TEST(RangeObjective, ACoarserTableStillKnowsThePlace) {
  const auto map = asymmetricWorld();
  const Pose2 truth{2.5, 1.0, 0.0};
  const Scan scan = ToyLaser{61}.observe(map, truth).scan;
  const TableObjective table(
      {}, scan,
      std::make_shared<const RangeRows>(std::make_shared<const RangeTable>(*map, kMaxRange, 3)));
  EXPECT_LT(costAt(table, truth), 0.12);
  EXPECT_GT(costAt(table, {7.0, 4.0, 0.0}), 0.13);
}

}  // namespace adaptive_localization
