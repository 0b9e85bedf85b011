// SPDX-License-Identifier: BSD-3-Clause
#include "observation/likelihood_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/toy_scores.hpp"

namespace adaptive_localization {
namespace {

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
  ToyModelOptions options = modelOptions("likelihood_field_prob");
  options.laser_z_rand = 0.0;
  const double score = scoreAt(options, wall(), hitBeforeWall(50), kInLane);
  EXPECT_TRUE(std::isfinite(score));
  EXPECT_LT(score, scoreAt(options, wall(), hitBeforeWall(0), kInLane));
}

TEST(LikelihoodField, IsBlunterWhereParticlesAreSparse) {
  ToyModelOptions options = modelOptions("likelihood_field_prob");
  options.laser_sigma_sparse = 0.3;
  const auto likelihoodOf = [&](double distance, double sigma) {
    return std::log(0.9 * std::exp(-0.5 * distance * distance / (sigma * sigma)) + 0.01);
  };
  const Observations seen = hitBeforeWall(3);  // 0.15 m
  Particles dense(40);
  for (Eigen::Index i = 0; i < dense.size(); ++i) dense.setPose(i, kInLane);
  EXPECT_NEAR(scoresOf(options, wall(), seen, dense).log_likelihood[0], likelihoodOf(0.15, 0.1),
              1e-3);
  Particles sparse = dense;
  sparse.setPose(8, kInLane * Pose2{5.0, 0.0, 0.0});
  EXPECT_NEAR(scoresOf(options, wall(), seen, sparse).log_likelihood[0], likelihoodOf(0.15, 0.3),
              1e-3);
  options.laser_sigma_sparse = 0.0;
  EXPECT_NEAR(scoresOf(options, wall(), seen, sparse).log_likelihood[0], likelihoodOf(0.15, 0.1),
              1e-3);
}

/// The hit of hitBeforeWall(), and this many beams to both sides of the lane that saw nothing, and
/// ahead, where the wall is.
Observations openBeforeWall(int aside, int ahead) {
  Observations seen = hitBeforeWall(0);
  seen.scan.no_return_bearing =
      Eigen::ArrayXf::Constant(aside + ahead, static_cast<float>(kPi / 2));
  seen.scan.no_return_bearing.head(ahead) = 0.0F;
  return seen;
}

TEST(LikelihoodField, CountsNoReturnsWhereTheyAreMostBeams) {
  ToyModelOptions options = modelOptions("likelihood_field");
  options.laser_z_max = 0.1;
  const double hit = std::log(fieldLikelihood(0.0)), miss = std::log(0.1);
  const auto score = [&](int aside, int ahead) {
    return scoreAt(options, wall(), openBeforeWall(aside, ahead), kInLane);
  };
  EXPECT_NEAR(score(0, 1), hit, 1e-4);  // as many as hits
  EXPECT_NEAR(score(5, 1), hit, 1e-4);  // one alone
  EXPECT_NEAR(score(0, 2), hit, 1e-4);  // all of all particles: the map is wrong
  EXPECT_NEAR(score(18, 2), (hit + 2 * miss) * 12 / 21, 1e-4);  // tempered together
  EXPECT_NEAR(score(6, 2), hit + 2 * std::log(0.25), 1e-4);     // a quarter is usual
  options.laser_z_max = 0.0;
  EXPECT_NEAR(score(20, 3), (hit + 3 * std::log(3.0 / 23)) * 12 / 24, 1e-4);
  Particles particles(1);
  EXPECT_EQ(scoresOf(options, wall(), openBeforeWall(3, 4), particles).beams, 8.0);
}

TEST(LikelihoodField, LeavesNoReturnsToOthersInAmclsForms) {
  for (const char* type : {"likelihood_field_prob", "likelihood_field_cubed"}) {
    const auto options = modelOptions(type);
    EXPECT_EQ(scoreAt(options, wall(), openBeforeWall(3, 4), kInLane),
              scoreAt(options, wall(), hitBeforeWall(0), kInLane));
  }
}

TEST(LikelihoodField, IsNotDrawnToAWallByAFewHits) {
  const auto map = toyWorld(Art(40, std::string(10, '.') + "#" + std::string(9, '.')), 0.25, {}, 1);
  Observations seen = hitsAt({{1.0, -0.1}, {1.0, 0.0}, {1.0, 0.1}}, 3.0);  // somebody's legs
  seen.scan.no_return_bearing = Eigen::ArrayXf::LinSpaced(60, -0.9F, 0.9F);
  Particles particles(2);
  particles.setPose(0, {6.0, 5.0, 0.0});  // in the open
  particles.setPose(1, {1.6, 5.0, 0.0});  // before a wall, which they fit
  const auto by = [&](const char* type) {
    return scoresOf(modelOptions(type), map, seen, particles).log_likelihood;
  };
  EXPECT_GT(by("likelihood_field")[0], by("likelihood_field")[1] + 5.0);
  EXPECT_LT(by("likelihood_field_prob")[0], by("likelihood_field_prob")[1] - 5.0);
}

/// Skipping of the beams that few particles explain: ten hits on the wall, `odd` ones `cells` away.
double skippingScore(ToyModelOptions options, int odd, int cells) {
  options.do_beamskip = true;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 10; ++i) {
    points.emplace_back(0.05 * (60 - (i < odd ? cells : 0)) + 0.025 - 1.0, 0.0);
  }
  return scoreAt(options, wall(), hitsAt(points, 10.0), kInLane);
}

TEST(BeamSkipping, LeavesOutBeamsThatNobodyExplains) {
  ToyModelOptions options = modelOptions("likelihood_field_prob");
  options.beam_skip_distance = 0.5;
  options.beam_skip_error_threshold = 0.6;
  const double hit = std::log(fieldLikelihood(0.0)), miss = std::log(fieldLikelihood(1.0));
  EXPECT_NEAR(skippingScore(options, 3, 20), 7 * hit, 1e-2);
  EXPECT_NEAR(skippingScore(options, 7, 20), 3 * hit + 7 * miss, 1e-2);  // too many: none left out
  options.do_beamskip = false;
  EXPECT_NEAR(skippingScore(options, 3, 4), 7 * hit + 3 * std::log(fieldLikelihood(0.2)), 1e-2);
}

TEST(BeamSkipping, GoesByTheDistanceHoweverNarrowTheLikelihood) {
  ToyModelOptions options = modelOptions("likelihood_field_prob");
  options.laser_sigma_hit = 0.03;
  options.beam_skip_distance = 0.5;
  options.beam_skip_error_threshold = 1.0;
  const double hit = std::log(0.9 + 0.01), miss = std::log(0.01);
  EXPECT_NEAR(skippingScore(options, 4, 9), 6 * hit + 4 * miss, 1e-2);  // 0.45 m: explained
  EXPECT_NEAR(skippingScore(options, 4, 11), 6 * hit, 1e-2);            // 0.55 m: not
}

TEST(BeamSkipping, CountsTheShareOfParticles) {
  ToyModelOptions options = modelOptions("likelihood_field_prob");
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
  ToyModelOptions options = modelOptions("likelihood_field_prob");
  options.do_beamskip = true;
  Particles particles(2);
  particles.setPose(0, {0.1, 0.025, 0.0});
  particles.setPose(1, {2.5, 0.025, 0.0});
  EXPECT_EQ(scoresOf(options, wall(), hitsAt({{0.1, 0.0}}, 10.0), particles).beams, 1.0);
}

}  // namespace
}  // namespace adaptive_localization
