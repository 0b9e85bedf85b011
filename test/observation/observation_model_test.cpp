// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/observation/observation_model.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/parallel.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_scores.hpp"

namespace adaptive_localization {
namespace {

/// A free pose of the symmetric world with some room around it, every other time the last one
/// turned by half a turn: what the world's shape does to scores cancels, what the model does does
/// not.
class FreePoses {
 public:
  FreePoses(const Map& map, std::uint64_t seed) : map_(map), field_(*map), rng_(seed) {}

  Pose2 next() {
    turn_ = !turn_;
    if (!turn_) return last_ = Pose2{6.0, 3.0, kPi} * last_;
    for (;;) {
      last_ = {rng_.uniform(0.0, 6.0), rng_.uniform(0.0, 3.0), rng_.uniform(-kPi, kPi)};
      const Eigen::Vector2d point(last_.x, last_.y);
      if (map_->isFree(map_->lattice().cellAt(point)) && field_.at(point) > 0.3) return last_;
    }
  }

 private:
  Map map_;
  DistanceField field_;
  Rng rng_;
  Pose2 last_;
  bool turn_{false};
};

/// The observations with ranges off by up to half a cell. Without that, hits lie exactly on sides
/// of cells, of which two belong to a wall's cell and two to its neighbours.
Observations roughly(Observations seen, Rng& rng) {
  Scan& scan = seen.scan;
  for (Eigen::Index i = 0; i < scan.x.size(); ++i) {
    const auto off = static_cast<float>(rng.uniform(-0.025, 0.025));
    scan.range[i] += off;
    scan.x[i] += off * std::cos(scan.bearing[i]);
    scan.y[i] += off * std::sin(scan.bearing[i]);
  }
  return seen;
}

class EveryModel : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Observation, EveryModel,
                         testing::Values("likelihood_field", "likelihood_field_prob",
                                         "likelihood_field_cubed", "beam", "inverse_l1"));

TEST_P(EveryModel, IsHighestWhereTheRobotIsAndWithoutBias) {
  const Map map = symmetricWorld();
  FreePoses poses(map, 1);
  Rng rng(2);
  const ToyModelOptions options = modelOptions(GetParam());
  const auto model = makeModel(options, map);
  constexpr int kSide = 13;       // a lattice of 13 x 13 poses 1 cm apart
  constexpr double kStep = 0.01;  // m
  constexpr int kScans = 300;
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();
  for (int scan = 0; scan < kScans; ++scan) {
    const Pose2 truth = poses.next();
    const Observations seen = roughly(ToyLaser{61, -kPi, kPi, 20.0}.observe(map, truth), rng);
    Particles particles(kSide * kSide);
    for (int i = 0; i < kSide * kSide; ++i) {
      particles.setPose(i, {truth.x + kStep * (i % kSide - kSide / 2),
                            truth.y + kStep * (i / kSide - kSide / 2), truth.theta});
    }
    Eigen::ArrayXd score = Eigen::ArrayXd::Zero(particles.size());
    model->score(seen, particles, score);
    // the middle of the best poses: quantised models have ties
    const double best = score.maxCoeff() - 1e-9;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; i < particles.size(); ++i) {
      if (score[i] < best) continue;
      sum += Eigen::Vector2d(particles.x[i] - truth.x, particles.y[i] - truth.y);
    }
    const Eigen::Vector2d off = sum / static_cast<double>((score >= best).count());
    EXPECT_LT(off.norm(), 0.05) << "scan " << scan;  // a cell
    bias += off / kScans;
  }
  EXPECT_LT(bias.cwiseAbs().maxCoeff(), 0.003);
}

TEST_P(EveryModel, IsFiniteForAnyPose) {
  const Map map = asymmetricWorld();
  const Observations seen = ToyLaser{31, -2.0, 2.0, 5.0}.observe(map, {1.2, 1.3, 0.0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1e12, -1e300, 50.0}) {
    EXPECT_TRUE(std::isfinite(scoreAt(modelOptions(GetParam()), map, seen, {bad, 1.0, 0.0})));
    EXPECT_TRUE(std::isfinite(scoreAt(modelOptions(GetParam()), map, seen, {1.0, bad, 0.0})));
    EXPECT_TRUE(std::isfinite(scoreAt(modelOptions(GetParam()), map, seen, {1.0, 1.0, bad})));
  }
}

TEST_P(EveryModel, AddsNothingWithoutAHit) {
  const Map map = asymmetricWorld();
  Observations blind = ToyLaser{31, -2.0, 2.0, 0.05}.observe(map, {1.2, 1.3, 0.0});
  ASSERT_EQ(blind.scan.hits(), 0);
  Particles particles(3);
  EXPECT_EQ(scoresOf(modelOptions(GetParam()), map, blind, particles).beams, 0.0);
  Eigen::ArrayXd before = Eigen::ArrayXd::Constant(3, -4.5);
  makeModel(modelOptions(GetParam()), map)->score(blind, particles, before);
  EXPECT_TRUE((before == -4.5).all());
  before.setConstant(-4.5);
  makeModel(modelOptions(GetParam()), map)->score(Observations{}, particles, before);
  EXPECT_TRUE((before == -4.5).all());
}

TEST_P(EveryModel, AddsToWhatIsThere) {
  const Map map = asymmetricWorld();
  const Observations seen = ToyLaser{}.observe(map, {1.2, 1.3, 0.0});
  Particles particles(2);
  particles.setPose(0, {1.2, 1.3, 0.0});
  particles.setPose(1, {1.3, 1.3, 0.1});
  const Scores fresh = scoresOf(modelOptions(GetParam()), map, seen, particles);
  Eigen::ArrayXd added = Eigen::ArrayXd::Constant(2, 10.0);
  makeModel(modelOptions(GetParam()), map)->score(seen, particles, added);
  EXPECT_TRUE((added - 10.0).isApprox(fresh.log_likelihood));
  EXPECT_GT(fresh.beams, 0.0);
}

TEST_P(EveryModel, DoesNotCareHowTheMapsOriginIsTurned) {
  const Pose2 origin{-4.0, 9.0, 2.2};
  const Map straight = asymmetricWorld(), turned = asymmetricWorld(origin);
  Rng rng(3);
  Particles here(300), there(300);
  for (Eigen::Index i = 0; i < here.size(); ++i) {
    here.setPose(i, {rng.uniform(0.0, 10.0), rng.uniform(0.0, 5.0), rng.uniform(-kPi, kPi)});
    there.setPose(i, origin * here.pose(i));
  }
  const Observations seen = ToyLaser{}.observe(straight, {1.2, 1.3, 0.4});
  const ToyModelOptions options = modelOptions(GetParam());
  const Eigen::ArrayXd a = scoresOf(options, straight, seen, here).log_likelihood;
  const Eigen::ArrayXd b = scoresOf(options, turned, seen, there).log_likelihood;
  // hits on a border between cells may be rounded differently
  const double spread = a.maxCoeff() - a.minCoeff();
  EXPECT_LT((a - b).abs().maxCoeff(), 0.05 * spread);
  EXPECT_LT((a - b).abs().mean(), 0.002 * spread);
}

TEST_P(EveryModel, GivesTheSameBitsForAnyNumberOfThreads) {
  const Map map = asymmetricWorld();
  const Observations seen = ToyLaser{31, -2.0, 2.0, 5.0}.observe(map, {1.2, 1.3, 0.0});
  Rng rng(4);
  Particles particles(3000);
  for (Eigen::Index i = 0; i < particles.size(); ++i) particles.setPose(i, randomPose(rng, 8.0));
  const ToyModelOptions options = modelOptions(GetParam());
  const Eigen::ArrayXd one = scoresOf(options, map, seen, particles).log_likelihood;
  setThreads(3);
  const Eigen::ArrayXd three = scoresOf(options, map, seen, particles).log_likelihood;
  setThreads(1);
  EXPECT_TRUE((one == three).all());
}

}  // namespace
}  // namespace adaptive_localization
