// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/filters/pose_histogram.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <cmath>

#include "adaptive_localization/particle/resampling.hpp"
#include "adaptive_localization/particle/summary.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kPlace{3.03, 1.77, 0.4321};

PoseHistogram histogram(double cell = 0.1, int headings = 72) {
  return {asymmetricWorld(), cell, headings};
}

Gaussian2 roughly(const Pose2& mean, double x, double y, double theta) {
  return {mean, Eigen::Vector3d(x * x, y * y, theta * theta).asDiagonal()};
}

Mode momentsOf(const PoseHistogram& belief) {
  const Particles poses = belief.poses(belief.cellsAbove(0.0));
  std::vector<Eigen::Index> all(static_cast<std::size_t>(poses.size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Eigen::Index>(i);
  return meanAndCovariance(poses, normalisedWeights(poses.log_weight), all);
}

double sumOf(const PoseHistogram& belief) {
  return belief.poses(belief.cellsAbove(0.0)).log_weight.exp().sum();
}

TEST(PoseHistogram, IsSpreadOverFreeCellsAndAllHeadings) {
  const auto map = asymmetricWorld();
  PoseHistogram belief(map, map->lattice().resolution(), 8);  // its cells are the map's
  const auto cells = belief.cellsAbove(0.0);
  EXPECT_EQ(cells.size(), 8 * map->countFree());
  const Particles poses = belief.poses(cells);
  for (Eigen::Index i = 0; i < poses.size(); ++i) {
    ASSERT_TRUE(map->isFree(map->lattice().cellAt({poses.x[i], poses.y[i]})));
  }
}

TEST(PoseHistogram, IsAsLargeAsWhatIsKnownOfTheMap) {
  const Lattice lattice(2000, 3000, 0.05, {-50.0, -75.0, 0.2});
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
  for (int x = 400; x < 600; ++x) cells[lattice.index({x, 700})] = OccupancyGrid::kFree;
  const auto map = std::make_shared<const OccupancyGrid>(lattice, cells);
  EXPECT_DOUBLE_EQ(PoseHistogram::countCells(*map, 0.05, 10), 220 * 21 * 10);
  const PoseHistogram belief(map, 0.05, 10);
  EXPECT_EQ(belief.cellsAbove(0.0).size(), 200u * 10u);
}

TEST(PoseHistogram, HoldsAGaussianWithItsMeanInACell) {
  auto belief = histogram();
  belief.set(roughly(kPlace, 0.3, 0.2, 0.15));
  const Mode held = momentsOf(belief);
  EXPECT_THAT(held.T_map_base, PoseNear(kPlace, 1e-3, 1e-3));
  EXPECT_NEAR(std::sqrt(held.covariance(0, 0)), 0.3, 0.01);
  EXPECT_NEAR(std::sqrt(held.covariance(1, 1)), 0.2, 0.01);
  EXPECT_NEAR(std::sqrt(held.covariance(2, 2)), 0.15, 0.01);

  belief.set(Gaussian2{kPlace, Eigen::Matrix3d::Zero()});
  const Particles one = belief.poses(belief.cellsAbove(1e-6));
  ASSERT_EQ(one.size(), 1);
  EXPECT_THAT(one.pose(0), PoseNear(kPlace, 1e-9, 1e-9));
}

TEST(PoseHistogram, MovesExactlyWhateverTheNumberOfSteps) {
  auto belief = histogram(0.2, 20);
  belief.set(Gaussian2{kPlace, Eigen::Matrix3d::Zero()});
  Pose2 truth = kPlace;
  for (int i = 0; i < 300; ++i) {
    const Pose2 motion{i % 2 ? 0.013 : -0.011, 0.003, i % 3 ? 0.07 : -0.02};
    truth = truth * motion;
    belief.move(motion, Eigen::Matrix3d::Zero());
    const Particles one = belief.poses(belief.cellsAbove(1e-6));
    ASSERT_EQ(one.size(), 1) << i;
    ASSERT_THAT(one.pose(0), PoseNear(truth, 1e-9, 1e-9)) << i;
  }
}

TEST(PoseHistogram, GrowsByTheNoiseOfEachMotion) {
  auto belief = histogram(0.1, 90);
  belief.set(roughly(kPlace, 0.1, 0.1, 0.1));
  const Mode before = momentsOf(belief);
  const Eigen::Matrix3d noise = Eigen::Vector3d(0.0016, 0.0004, 0.0009).asDiagonal();
  for (int i = 0; i < 10; ++i) belief.move({}, noise);
  const Mode after = momentsOf(belief);
  EXPECT_THAT(after.T_map_base, PoseNear(kPlace, 0.01, 0.01));
  const double trace = (after.covariance - before.covariance).topLeftCorner<2, 2>().trace();
  EXPECT_NEAR(trace, 0.02, 0.001);
  EXPECT_NEAR(after.covariance(2, 2) - before.covariance(2, 2), 0.009, 0.0005);
  // along the heading, which is spread by 0.1 to 0.14 rad, more than across it
  EXPECT_GT(after.covariance(0, 0) - before.covariance(0, 0), 0.011);
}

TEST(PoseHistogram, LosesNothingInsideTheMap) {
  auto belief = histogram();
  belief.set(roughly({5.0, 2.5, 0.0}, 0.2, 0.2, 0.2));
  const double before = sumOf(belief);
  for (int i = 0; i < 12; ++i) {
    belief.move({0.05, 0.0, 0.4}, Eigen::Vector3d(1e-4, 1e-4, 1e-3).asDiagonal());
  }
  EXPECT_NEAR(sumOf(belief), before, 1e-3 * before);
}

TEST(PoseHistogram, LosesWhatLeavesTheMap) {
  auto belief = histogram();
  belief.set(roughly(kPlace, 0.2, 0.2, 0.1));
  belief.move({1e3, 0.0, 0.0}, Eigen::Matrix3d::Zero());
  EXPECT_TRUE(belief.cellsAbove(0.0).empty());
  belief.move({-1e3, 0.0, 0.0}, Eigen::Matrix3d::Identity());
  EXPECT_TRUE(belief.cellsAbove(0.0).empty());
}

TEST(PoseHistogram, TakesAMotionOfSenselessNoise) {
  auto belief = histogram(0.2, 20);
  belief.set(roughly(kPlace, 0.2, 0.2, 0.1));
  belief.move({0.1, 0.0, 0.1}, Eigen::Matrix3d::Constant(std::nan("")));
  EXPECT_GT(belief.cellsAbove(1e-6).size(), 1000u);
  EXPECT_TRUE(belief.poses(belief.cellsAbove(0.0)).log_weight.isFinite().all());
}

TEST(PoseHistogram, IsSpreadWhereAPriorIsOffTheMap) {
  auto belief = histogram(0.2, 20);
  const std::size_t everywhere = belief.cellsAbove(0.0).size();
  belief.set(roughly({-500.0, 900.0, 1.0}, 0.2, 0.2, 0.1));
  EXPECT_EQ(belief.cellsAbove(0.0).size(), everywhere);
  belief.set(Gaussian2{{std::nan(""), 0.0, 0.0}, Eigen::Matrix3d::Identity()});
  EXPECT_EQ(belief.cellsAbove(0.0).size(), everywhere);
  Particles away(3);
  away.x.setConstant(1e6);
  belief.set(away);
  EXPECT_EQ(belief.cellsAbove(0.0).size(), everywhere);
}

TEST(PoseHistogram, MixesTheBeliefWithAnywhere) {
  auto belief = histogram(0.2, 20);
  const auto everywhere = static_cast<double>(belief.cellsAbove(0.0).size());
  belief.set(Gaussian2{kPlace, Eigen::Matrix3d::Zero()});
  belief.mix(0.25);
  const Particles poses = belief.poses(belief.cellsAbove(1e-9));
  EXPECT_NEAR(poses.log_weight.exp().sum(), 1.0, 1e-4);
  EXPECT_NEAR(poses.log_weight.maxCoeff(), std::log(0.75), 1e-3);
  EXPECT_NEAR(std::exp(poses.log_weight.minCoeff()) * everywhere, 0.25, 0.03);
}

TEST(PoseHistogram, HoldsWhatItIsAssigned) {
  auto belief = histogram();
  belief.set(roughly(kPlace, 0.2, 0.2, 0.1));
  auto cells = belief.cellsAbove(0.1);
  ASSERT_GT(cells.size(), 10u);
  cells.resize(3);
  belief.assign(cells, Eigen::Array3d(0.5, 0.0, 0.25));
  const std::vector<std::uint32_t> held = belief.cellsAbove(0.0);
  EXPECT_THAT(held, testing::ElementsAre(cells[0], cells[2]));
  EXPECT_NEAR(belief.poses(held).log_weight[1], std::log(0.25), 1e-6);
}

TEST(PoseHistogram, TurnsWithARotatedMap) {
  const Pose2 origin{-4.0, 3.0, 0.7};
  PoseHistogram belief(asymmetricWorld(origin), 0.1, 60);
  const Pose2 place = origin * kPlace, motion{0.37, 0.05, 0.9};
  belief.set(roughly(place, 0.3, 0.05, 0.05));
  EXPECT_THAT(momentsOf(belief).T_map_base, PoseNear(place, 1e-3, 1e-3));
  EXPECT_NEAR(momentsOf(belief).covariance(0, 0), 0.09, 0.005);
  belief.set(Gaussian2{place, Eigen::Matrix3d::Zero()});
  belief.move(motion, Eigen::Matrix3d::Zero());
  EXPECT_THAT(momentsOf(belief).T_map_base, PoseNear(place * motion, 1e-9, 1e-9));
}

}  // namespace
}  // namespace adaptive_localization
