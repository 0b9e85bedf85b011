// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/field_objective.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

double costAt(const Objective& objective, const Pose2& pose) {
  Eigen::ArrayXXd positions(1, 3);
  positions << pose.x, pose.y, pose.theta;
  Eigen::ArrayXd cost(1);
  objective.evaluate(positions, cost);
  return cost[0];
}

}  // namespace

TEST(FieldObjective, IsLeastWhereTheScanWasTaken) {
  const auto map = asymmetricWorld();
  const auto field = std::make_shared<const DistanceField>(*map);
  const Pose2 truth{2.52, 1.02, 0.3};
  const FieldObjective objective(ToyLaser{61}.observe(map, truth).scan, 60, 0.3, field);
  EXPECT_LT(costAt(objective, truth), 0.06);  // a cell is 0.1 m wide
  for (const Pose2& wrong : {Pose2{2.8, 1.02, 0.3}, Pose2{2.52, 1.02, 0.6}, Pose2{7, 4, 0.3}}) {
    EXPECT_GT(costAt(objective, wrong), costAt(objective, truth) + 0.03);
  }
}

TEST(FieldObjective, IsTheMeanDistanceOfHitsFromWalls) {
  for (const Pose2& origin : {Pose2{}, Pose2{-3.0, 2.0, 0.7}}) {
    const auto map = asymmetricWorld(origin);
    const auto field = std::make_shared<const DistanceField>(*map);
    Scan scan;
    scan.x.resize(3);
    scan.y.resize(3);
    scan.x << 1.0F, 1.5F, 2.0F;
    scan.y << 0.5F, -0.2F, 0.3F;
    const Pose2 pose = origin * Pose2{2.0, 1.0, 0.4};
    double sum = 0.0;
    for (Eigen::Index j = 0; j < 3; ++j) {
      const Eigen::Vector2d hit = pose * Eigen::Vector2d(scan.x[j], scan.y[j]);
      sum += std::min(field->at(hit), 0.3);
    }
    EXPECT_NEAR(costAt(FieldObjective(scan, 60, 0.3, field), pose), sum / 3.0, 1e-9);
  }
}

TEST(FieldObjective, CutsOffOutsideTheMapAndLeavesOutWhatIsNoNumber) {
  const auto map = asymmetricWorld();
  const auto field = std::make_shared<const DistanceField>(*map);
  Scan scan;
  scan.x.resize(2);
  scan.x << 1.0F, std::numeric_limits<float>::quiet_NaN();
  scan.y.setZero(2);
  const FieldObjective objective(scan, 60, 0.3, field);
  EXPECT_NEAR(costAt(objective, {1e9, -1e9, 0.0}), 0.3, 1e-9);
  EXPECT_EQ(costAt(FieldObjective(Scan{}, 60, 0.3, field), {1.0, 1.0, 0.0}), 0.0);
}

}  // namespace adaptive_localization
