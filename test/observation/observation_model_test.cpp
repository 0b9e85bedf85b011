// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/observation/observation_model.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "adaptive_localization/parallel.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using Map = std::shared_ptr<const OccupancyGrid>;

ObservationOptions modelOptions(const std::string& type) {
  ObservationOptions options;
  options.laser_model_type = type;
  options.laser_z_hit = 0.9;
  options.laser_z_rand = 0.1;
  options.laser_sigma_hit = 0.1;
  options.laser_likelihood_max_dist = 2.0;
  options.effective_beams = 12.0;
  return options;
}

std::unique_ptr<ObservationModel> makeModel(const ObservationOptions& options, const Map& map) {
  FilterContext context;
  context.map = map;
  context.distance_field = std::make_shared<const DistanceField>(*map);
  return makeObservationModel(options, context);
}

struct Scores {
  Eigen::ArrayXd log_likelihood;
  double beams;
};

Scores scoresOf(const ObservationOptions& options, const Map& map, const Observations& seen,
                const Particles& particles) {
  Scores scores{Eigen::ArrayXd::Zero(particles.size()), 0.0};
  scores.beams = makeModel(options, map)->score(seen, particles, scores.log_likelihood);
  return scores;
}

double scoreAt(const ObservationOptions& options, const Map& map, const Observations& seen,
               const Pose2& pose) {
  Particles particles(1);
  particles.setPose(0, pose);
  return scoresOf(options, map, seen, particles).log_likelihood[0];
}

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
  const ObservationOptions options = modelOptions(GetParam());
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
  const ObservationOptions options = modelOptions(GetParam());
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
  const ObservationOptions options = modelOptions(GetParam());
  const Eigen::ArrayXd one = scoresOf(options, map, seen, particles).log_likelihood;
  setThreads(3);
  const Eigen::ArrayXd three = scoresOf(options, map, seen, particles).log_likelihood;
  setThreads(1);
  EXPECT_TRUE((one == three).all());
}

/// A wall one cell thick; the hit of a beam of 2 m from the origin is so many cells before it.
const Map& wall() {
  static const Map map = toyWorld({Art(1, std::string(60, '.') + "#").front()}, 0.05);
  return map;
}
Observations hitBeforeWall(int cells, int beams = 1) {
  const double x = 0.05 * (60 - cells) + 0.025 - 1.0;
  return hitsAt(std::vector<Eigen::Vector2d>(static_cast<std::size_t>(beams), {x, 0.0}), 10.0);
}
const Pose2 kInLane{1.0, 0.025, 0.0};

double fieldLikelihood(double distance) {  // with the options above and a laser of 10 m
  return 0.9 * std::exp(-0.5 * distance * distance / 0.01) + 0.1 / 10.0;
}

TEST(LikelihoodField, IsTheFormulaTempered) {
  for (const int cells : {0, 1, 2, 5, 50}) {
    const double one = std::log(fieldLikelihood(0.05 * std::min(cells, 40)));
    const auto options = modelOptions("likelihood_field");
    EXPECT_NEAR(scoreAt(options, wall(), hitBeforeWall(cells), kInLane), one, 1e-4);
    EXPECT_NEAR(scoreAt(options, wall(), hitBeforeWall(cells, 12), kInLane), 12 * one, 1e-3);
    EXPECT_NEAR(scoreAt(options, wall(), hitBeforeWall(cells, 24), kInLane), 12 * one, 1e-3);
    EXPECT_NEAR(
        scoreAt(modelOptions("likelihood_field_prob"), wall(), hitBeforeWall(cells, 24), kInLane),
        24 * one, 2e-3);
  }
}

TEST(LikelihoodField, TellsHowManyBeamsItsScoreIsWorth) {
  Particles particles(1);
  const auto beams = [&](const char* type, int hits) {
    return scoresOf(modelOptions(type), wall(), hitBeforeWall(0, hits), particles).beams;
  };
  EXPECT_EQ(beams("likelihood_field", 5), 5.0);
  EXPECT_EQ(beams("likelihood_field", 50), 12.0);
  EXPECT_EQ(beams("likelihood_field_prob", 50), 50.0);
  EXPECT_EQ(beams("beam", 50), 12.0);
}

TEST(LikelihoodField, HasAmclsCubedForm) {
  for (const int cells : {0, 1, 3, 50}) {
    const double p = fieldLikelihood(0.05 * std::min(cells, 40));
    const double expected = std::log(1.0 + 7.0 * p * p * p);
    EXPECT_NEAR(
        scoreAt(modelOptions("likelihood_field_cubed"), wall(), hitBeforeWall(cells, 7), kInLane),
        expected, 1e-4);
  }
}

TEST(LikelihoodField, IsFiniteWithoutRandomReadings) {
  ObservationOptions options = modelOptions("likelihood_field_prob");
  options.laser_z_rand = 0.0;
  const double score = scoreAt(options, wall(), hitBeforeWall(50), kInLane);
  EXPECT_TRUE(std::isfinite(score));
  EXPECT_LT(score, scoreAt(options, wall(), hitBeforeWall(0), kInLane));
}

/// Skipping of the beams that few particles explain: ten hits on the wall, `odd` ones `cells` away.
double skippingScore(ObservationOptions options, int odd, int cells) {
  options.do_beamskip = true;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 10; ++i) {
    points.emplace_back(0.05 * (60 - (i < odd ? cells : 0)) + 0.025 - 1.0, 0.0);
  }
  return scoreAt(options, wall(), hitsAt(points, 10.0), kInLane);
}

TEST(BeamSkipping, LeavesOutBeamsThatNobodyExplains) {
  ObservationOptions options = modelOptions("likelihood_field_prob");
  options.beam_skip_distance = 0.5;
  options.beam_skip_error_threshold = 0.6;
  const double hit = std::log(fieldLikelihood(0.0)), miss = std::log(fieldLikelihood(1.0));
  EXPECT_NEAR(skippingScore(options, 3, 20), 7 * hit, 1e-2);
  EXPECT_NEAR(skippingScore(options, 7, 20), 3 * hit + 7 * miss, 1e-2);  // too many: none left out
  options.do_beamskip = false;
  EXPECT_NEAR(skippingScore(options, 3, 4), 7 * hit + 3 * std::log(fieldLikelihood(0.2)), 1e-2);
}

TEST(BeamSkipping, GoesByTheDistanceHoweverNarrowTheLikelihood) {
  ObservationOptions options = modelOptions("likelihood_field_prob");
  options.laser_sigma_hit = 0.03;
  options.beam_skip_distance = 0.5;
  options.beam_skip_error_threshold = 1.0;
  const double hit = std::log(0.9 + 0.01), miss = std::log(0.01);
  EXPECT_NEAR(skippingScore(options, 4, 9), 6 * hit + 4 * miss, 1e-2);  // 0.45 m: explained
  EXPECT_NEAR(skippingScore(options, 4, 11), 6 * hit, 1e-2);            // 0.55 m: not
}

TEST(BeamSkipping, CountsTheShareOfParticles) {
  ObservationOptions options = modelOptions("likelihood_field_prob");
  options.do_beamskip = true;
  options.beam_skip_distance = 0.1;
  options.beam_skip_threshold = 0.3;
  options.beam_skip_error_threshold = 1.0;
  const Observations seen = hitsAt({{2.025, 0.0}, {2.025, 0.0}, {1.525, 0.0}}, 10.0);
  const auto used = [&](int explaining) {  // of ten particles, those that explain the third beam
    Particles particles(10);
    for (int i = 0; i < 10; ++i) {
      particles.setPose(i, {i < explaining ? 1.5 : 1.0, 0.025, 0.0});
    }
    return scoresOf(options, wall(), seen, particles).beams;
  };
  EXPECT_EQ(used(3), 2.0);  // the share must exceed the threshold
  EXPECT_EQ(used(4), 3.0);
}

TEST(BeamSkipping, IsOffWhileTheCloudIsSpread) {
  ObservationOptions options = modelOptions("likelihood_field_prob");
  options.do_beamskip = true;
  Particles particles(2);
  particles.setPose(0, {0.1, 0.025, 0.0});
  particles.setPose(1, {2.5, 0.025, 0.0});
  EXPECT_EQ(scoresOf(options, wall(), hitsAt({{0.1, 0.0}}, 10.0), particles).beams, 1.0);
}

TEST(BeamModel, IsTheFourPartMixture) {
  ObservationOptions options = modelOptions("beam");
  options.laser_z_short = 0.05;
  options.laser_lambda_short = 0.2;
  options.laser_z_max = 0.07;
  const double expected = 2.0;  // from x = 1 to the wall's near side
  const auto direct = [&](double z) {
    const double d = (z - expected) / 0.1;
    return 0.9 * std::exp(-0.5 * d * d) + (z < expected ? 0.05 * 0.2 * std::exp(-0.2 * z) : 0.0) +
           0.1 / 10.0;
  };
  for (const double z : {1.0, 1.9, 2.05, 4.0}) {
    EXPECT_NEAR(scoreAt(options, wall(), hitsAt({{z, 0.0}}, 10.0), kInLane), std::log(direct(z)),
                1e-5);
  }
  Observations mixed = hitsAt({{1.9, 0.0}}, 10.0);
  mixed.scan.no_return_bearing = Eigen::ArrayXf::Zero(1);
  // the no-return is read as 10 m where 2 m are expected
  EXPECT_NEAR(scoreAt(options, wall(), mixed, kInLane), std::log(direct(1.9)) + std::log(0.07),
              1e-5);
}

TEST(BeamModel, LooksFromWhereTheSensorIs) {
  const ObservationOptions options = modelOptions("beam");
  Observations seen = hitsAt({{2.0, 0.0}}, 10.0);
  seen.scan.position = {0.5, 0.0};
  seen.scan.range[0] = 1.5F;
  EXPECT_NEAR(scoreAt(options, wall(), seen, kInLane), std::log(0.9 + 0.01), 1e-3);
}

TEST(InverseL1, IsTheInverseSumOfAbsoluteErrors) {
  const auto options = modelOptions("inverse_l1");
  EXPECT_NEAR(scoreAt(options, wall(), hitsAt({{1.5, 0.0}, {2.25, 0.0}}, 10.0), kInLane),
              -std::log(0.75), 1e-6);
  EXPECT_NEAR(scoreAt(options, wall(), hitsAt({{2.0, 0.0}}, 10.0), kInLane), -std::log(1e-3), 1e-3);
}

}  // namespace
}  // namespace adaptive_localization
