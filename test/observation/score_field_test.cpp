// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/observation/score_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "core/parallel.hpp"
#include "support/pose_matchers.hpp"
#include "support/random_grid.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// Sums of a toy scan's values over many poses, some of them off the map or no pose at all.
class ScoreFieldSums : public testing::Test {
 protected:
  ScoreFieldSums() : particles_(5003) {  // no multiple of eight lanes
    Rng rng(1);
    for (Eigen::Index i = 0; i < particles_.size(); ++i) {
      particles_.setPose(i, randomPose(rng, 12.0));
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    Eigen::Index i = 0;
    for (const double bad : {nan, inf, -inf, 1e30, -1e300}) {
      particles_.setPose(i++, {bad, 1.0, 0.0});
      particles_.setPose(i++, {1.0, bad, 0.0});
      particles_.setPose(i++, {1.0, 1.0, bad});
    }
  }

  using Table = ScoreField::Table;

  Eigen::ArrayXd sums(const Pose2& origin = {}, Table table = Table::kKept) const {
    const auto map = asymmetricWorld(origin);
    const ScoreField field(
        std::make_shared<const DistanceField>(*map), 2.0, [](double d) { return -d * d; }, table);
    const Scan scan = ToyLaser{}.observe(asymmetricWorld(), {1.2, 1.3, 0.3}).scan;
    Eigen::ArrayXd result(particles_.size());
    field.sum(scan.x, scan.y, particles_, result);
    return result;
  }

  Particles particles_;
};

TEST_F(ScoreFieldSums, AreTheSameBitsWithAndWithoutVectorInstructions) {
  for (const Pose2& origin : {Pose2{}, Pose2{-3.0, 1.0, 0.7}}) {
    for (const Table table : {Table::kKept, Table::kNone}) {
      ScoreField::usePortableInstructions(true);
      const Eigen::ArrayXd portable = sums(origin, table);
      ScoreField::usePortableInstructions(false);
      const Eigen::ArrayXd fast = sums(origin, table);
      EXPECT_TRUE((portable == fast).all()) << (portable - fast).abs().maxCoeff();
    }
  }
}

TEST_F(ScoreFieldSums, AreTheSameBitsWithAndWithoutATable) {
  const Eigen::ArrayXd with = sums(), without = sums({}, Table::kNone);
  EXPECT_LT(with.minCoeff(), with.maxCoeff());
  EXPECT_TRUE((with == without).all()) << (with - without).abs().maxCoeff();
}

TEST_F(ScoreFieldSums, AreTheSameBitsForAnyNumberOfThreads) {
  const Eigen::ArrayXd one = sums();
  setThreads(4);
  const Eigen::ArrayXd four = sums();
  setThreads(1);
  EXPECT_TRUE((one == four).all());
}

TEST_F(ScoreFieldSums, AreFiniteAndLeastForPosesThatAreNone) {
  const Eigen::ArrayXd all = sums();
  EXPECT_TRUE(all.allFinite());
  EXPECT_NEAR(all[0], all.minCoeff(), 1e-6);
}

TEST_F(ScoreFieldSums, AreTheDirectSums) {
  const auto map = asymmetricWorld();
  const DistanceField distances(*map);
  const Scan scan = ToyLaser{}.observe(map, {1.2, 1.3, 0.3}).scan;
  const Eigen::ArrayXd fast = sums();
  int compared = 0;
  for (Eigen::Index i = 20; i < particles_.size(); i += 7) {
    double direct = 0.0;
    for (Eigen::Index j = 0; j < scan.x.size(); ++j) {
      const Eigen::Vector2d hit = particles_.pose(i) * Eigen::Vector2d(scan.x[j], scan.y[j]);
      const double d = std::min(2.0, distances.at(hit));
      direct -= d * d;
    }
    // a hit on the border of two cells may be rounded into either
    ASSERT_NEAR(fast[i], direct, 0.5) << i;
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

TEST_F(ScoreFieldSums, CountTheSharesOfParticles) {
  const auto map = toyWorld({"..........#"}, 0.1);
  const ScoreField field(std::make_shared<const DistanceField>(*map), 2.0,
                         [](double d) { return -d; });
  Particles particles(10);
  for (Eigen::Index i = 0; i < 10; ++i) particles.setPose(i, {0.05 + 0.1 * double(i), 0.05, 0.0});
  const Eigen::ArrayXf x = Eigen::ArrayXf::Zero(1), y = Eigen::ArrayXf::Zero(1);
  EXPECT_DOUBLE_EQ(field.shareAbove(-0.35, x, y, particles)[0], 0.3);
}

/// On a long map with walls everywhere.
TEST(ScoreFieldTiles, AreMadeWhereParticlesSeeThem) {
  Rng rng(4);
  const auto map = randomGrid(rng, Lattice(6000, 70, 0.05, {-10.0, 3.0, 0.4}), 0.05);
  const auto distances = std::make_shared<const DistanceField>(*map);
  const auto square = [](double d) { return -d * d; };
  const Lattice& lattice = map->lattice();
  const Eigen::ArrayXf all_x = Eigen::ArrayXf::LinSpaced(50, -8.0F, 8.0F);
  const Eigen::ArrayXf y = Eigen::ArrayXf::LinSpaced(50, 2.0F, -3.0F);
  const ScoreField grown(distances, 2.0, square);
  const std::size_t all = grown.tilesToMake();
  EXPECT_EQ(all, distances->nearness().tiles());
  std::size_t before = all;
  for (int place = 0; place < 40; ++place) {  // at two ends of the map, beside it and in it
    const Eigen::ArrayXf x = (place % 3 == 0 ? 0.2F : 1.0F) * all_x;
    Particles particles(30);
    for (Eigen::Index i = 0; i < particles.size(); ++i) {
      const double along = (i % 2 == 0 ? 6.0 : -6.0) * place + (i % 2 == 0 ? -20.0 : 310.0);
      const Eigen::Vector2d at = lattice.origin() * Eigen::Vector2d(along, rng.uniform(-9.0, 9.0));
      particles.setPose(i, {at.x(), at.y(), rng.uniform(-kPi, kPi)});
    }
    Eigen::ArrayXd sums(particles.size()), expected(particles.size());
    grown.sum(x, y, particles, sums);
    const ScoreField whole(distances, 2.0, square);
    Particles everywhere(600);
    for (Eigen::Index i = 0; i < everywhere.size(); ++i) {
      const Eigen::Vector2d at = lattice.origin() * Eigen::Vector2d(0.5 * double(i), 1.0);
      everywhere.setPose(i, {at.x(), at.y(), 0.0});
    }
    Eigen::ArrayXd unused(everywhere.size());
    whole.sum(x, y, everywhere, unused);
    ASSERT_EQ(whole.tilesToMake(), 0U);
    whole.sum(x, y, particles, expected);
    EXPECT_TRUE((sums == expected).all()) << place;
    EXPECT_LE(grown.tilesToMake(), before);
    before = grown.tilesToMake();
    EXPECT_TRUE(place > 4 || before > all / 2) << place;
  }
  EXPECT_EQ(before, 0U) << "the two groups have met";
}

}  // namespace
}  // namespace adaptive_localization
