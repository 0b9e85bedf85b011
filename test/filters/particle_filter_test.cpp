// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/filters/particle_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/differential_drive.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// A filter with parts that record what they are told.
struct Recording {
  std::vector<double> likelihoods;  // told to the exploration
  std::vector<Pose2> best;
  std::vector<double> spreads;
  int explored{0};
  int conditioned{0};
  bool knows_where{false};
  double share{0.0};
  Eigen::Index count{100};
};

class ScriptedExploration : public Exploration {
 public:
  explicit ScriptedExploration(std::shared_ptr<Recording> recording) : r_(std::move(recording)) {}
  void reset() override {}
  void observe(const Evidence& evidence) override {
    r_->likelihoods.push_back(evidence.mean_likelihood);
    r_->best.push_back(evidence.best);
    r_->spreads.push_back(evidence.spread);
  }
  double share() const override { return r_->share; }
  void explored() override { ++r_->explored; }

 private:
  std::shared_ptr<Recording> r_;
};

class ScriptedSize : public SampleSize {
 public:
  explicit ScriptedSize(std::shared_ptr<Recording> recording) : r_(std::move(recording)) {}
  Eigen::Index initial() const override { return r_->count; }
  Eigen::Index initial(const PoseSampler&, Rng&) const override { return r_->count / 2; }
  Eigen::Index next(const Belief&, Rng&) override { return r_->count; }

 private:
  std::shared_ptr<Recording> r_;
};

/// A corridor far off; where it knows more after a scan, a point near it.
class ScriptedSampler : public FreeSpaceSampler {
 public:
  explicit ScriptedSampler(std::shared_ptr<Recording> recording)
      : FreeSpaceSampler(toyWorld({".........."}, 1.0, {50.0, 50.0, 0.0})),
        r_(std::move(recording)) {}
  bool condition(const Observations& observations) override {
    ++r_->conditioned;
    return knows_ = r_->knows_where && observations.stamp > 0.0;
  }
  Pose2 draw(Rng& rng) const override {
    return knows_ ? Pose2{70.0, 50.0, 0.0} : FreeSpaceSampler::draw(rng);
  }

 private:
  std::shared_ptr<Recording> r_;
  bool knows_{false};
};

/// log p = -(x - 1)^2 per beam, ten independent beams.
class HillModel : public ObservationModel {
 public:
  double score(const Observations&, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override {
    log_likelihood -= 10.0 * (particles.x - 1.0).square();
    return 10.0;
  }
};

ParticleFilter makeFilter(const std::shared_ptr<Recording>& recording, bool selective = false) {
  MotionOptions motion;
  motion.odom_noise_xy = motion.odom_noise_theta = 0.0;
  ParticleFilterParts parts;
  parts.motion = std::make_unique<DifferentialDrive>(motion);
  parts.observation = std::make_unique<HillModel>();
  parts.resampling = systematicIndices;
  parts.size = std::make_unique<ScriptedSize>(recording);
  parts.exploration = std::make_unique<ScriptedExploration>(recording);
  parts.elsewhere = std::make_unique<ScriptedSampler>(recording);
  ParticleFilterOptions options;
  options.resample_interval = 1;
  options.selective_resampling = selective;
  return ParticleFilter(options, std::move(parts), 1);
}

Gaussian2 at(double x, double deviation) {
  Gaussian2 prior{{x, 0.0, 0.0}, Eigen::Matrix3d::Zero()};
  prior.covariance(0, 0) = deviation * deviation;
  return prior;
}

TEST(ParticleFilter, DrawsItsFirstParticlesFromTheGaussian) {
  const auto recording = std::make_shared<Recording>();
  recording->count = 20000;
  ParticleFilter filter = makeFilter(recording);
  Gaussian2 prior{{1.0, 2.0, kPi}, Eigen::Matrix3d::Zero()};
  prior.covariance << 0.04, 0.03, 0.0, 0.03, 0.09, 0.0, 0.0, 0.0, 0.01;
  filter.reset(prior);
  const Estimate estimate = filter.estimate();
  EXPECT_THAT(estimate.T_map_base, PoseNear(prior.mean, 0.05, 0.01));
  const Particles& all = filter.hypotheses();
  const Eigen::ArrayXd dx = all.x - all.x.mean(), dy = all.y - all.y.mean();
  EXPECT_NEAR((dx * dx).mean(), 0.04, 0.002);
  EXPECT_NEAR((dx * dy).mean(), 0.03, 0.003);
  EXPECT_NEAR((dy * dy).mean(), 0.09, 0.004);
}

TEST(ParticleFilter, TellsTheMeanLikelihoodPerBeamBeforeWeightsAreNormalised) {
  const auto recording = std::make_shared<Recording>();
  ParticleFilter filter = makeFilter(recording);
  filter.reset(at(2.0, 0.0));
  filter.update({}, Observations{});
  filter.reset(at(1.5, 0.0));
  filter.update({}, Observations{});
  ASSERT_EQ(recording->likelihoods.size(), 2u);
  EXPECT_NEAR(recording->likelihoods[0], std::exp(-1.0), 1e-9);  // one would be the normalised sum
  EXPECT_NEAR(recording->likelihoods[1], std::exp(-0.25), 1e-9);
}

TEST(ParticleFilter, LooksElsewhereWithTheShareItIsTold) {
  const auto recording = std::make_shared<Recording>();
  ParticleFilter filter = makeFilter(recording);
  filter.reset(at(1.0, 0.0));
  recording->share = 0.25;
  const Estimate estimate = filter.update({}, Observations{});
  EXPECT_EQ((filter.hypotheses().x > 49.0).count(), 25);
  EXPECT_EQ(filter.hypotheses().size(), 100);
  EXPECT_EQ(recording->explored, 1);
  EXPECT_EQ(estimate.share_elsewhere, 0.25);
  EXPECT_EQ(estimate.modes.size(), 1u);  // of what was weighed, not of what was just thrown in
  recording->share = 0.0;
  EXPECT_EQ(filter.update({}, Observations{}).share_elsewhere, 0.0);
  EXPECT_EQ(recording->explored, 1);
}

TEST(ParticleFilter, AsksWhereToLookOnlyWhenItLooks) {
  const auto recording = std::make_shared<Recording>();
  ParticleFilter filter = makeFilter(recording);
  filter.reset(at(1.0, 0.0));
  filter.update({}, Observations{});
  EXPECT_EQ(recording->conditioned, 0);
  recording->share = 0.5;
  filter.update({}, Observations{});
  EXPECT_EQ(recording->conditioned, 1);
}

TEST(ParticleFilter, TellsOfTheParticleThatExplainsBestAndOfTheSpread) {
  const auto recording = std::make_shared<Recording>();
  recording->count = 20000;
  ParticleFilter filter = makeFilter(recording);
  filter.reset(at(0.5, 0.4));
  filter.update({}, Observations{});
  EXPECT_NEAR(recording->best.at(0).x, 1.0, 0.01);
  EXPECT_NEAR(recording->spreads.at(0), 0.4 * std::sqrt(2.0 / kPi), 0.01);
}

TEST(ParticleFilter, AnywhereBecomesTheRegionThatTheFirstScanLeaves) {
  const auto recording = std::make_shared<Recording>();
  ParticleFilter filter = makeFilter(recording);
  filter.reset(Anywhere{});
  EXPECT_EQ(filter.hypotheses().size(), 100);
  EXPECT_LT(filter.hypotheses().x.maxCoeff(), 61.0);
  recording->knows_where = true;
  recording->count = 80;
  filter.update({}, Observations{});  // tells nothing yet
  EXPECT_LT(filter.hypotheses().x.maxCoeff(), 61.0);
  filter.update({5.0, 0.0, 0.0}, {1.0, {}});
  EXPECT_EQ(filter.hypotheses().size(), 80);  // of 40, resampled
  EXPECT_EQ(filter.hypotheses().x.minCoeff(), 70.0);
  filter.update({1.0, 0.0, 0.0}, {2.0, {}});  // not again
  EXPECT_GT(filter.hypotheses().x.minCoeff(), 70.2);
  filter.reset(Anywhere{});
  EXPECT_LT(filter.hypotheses().x.maxCoeff(), 61.0);
  filter.reset(at(1.0, 0.0));
  filter.update({}, {3.0, {}});
  EXPECT_LT(filter.hypotheses().x.maxCoeff(), 2.0);
}

TEST(ParticleFilter, ChangesItsSizeWhenTold) {
  const auto recording = std::make_shared<Recording>();
  ParticleFilter filter = makeFilter(recording);
  filter.reset(at(1.0, 0.1));
  for (const Eigen::Index count : {30, 500, 1}) {
    recording->count = count;
    filter.update({}, Observations{});
    EXPECT_EQ(filter.hypotheses().size(), count);
  }
}

TEST(ParticleFilter, ConvergesToTheProductOfPriorAndLikelihoods) {
  const auto recording = std::make_shared<Recording>();
  recording->count = 20000;
  ParticleFilter filter = makeFilter(recording);
  filter.reset(at(0.8, 0.1));
  Estimate estimate = filter.update({}, Observations{});
  // prior N(0.8, 0.01), likelihood N(1, 1/20)
  const double variance = 1.0 / (1.0 / 0.01 + 20.0);
  EXPECT_NEAR(estimate.T_map_base.x, variance * (0.8 / 0.01 + 20.0), 0.004);
  EXPECT_NEAR(estimate.covariance(0, 0), variance, 0.0004);
  estimate = filter.update({}, Observations{});  // the same after resampling and once more
  const double second = 1.0 / (1.0 / 0.01 + 40.0);
  EXPECT_NEAR(estimate.T_map_base.x, second * (0.8 / 0.01 + 40.0), 0.004);
  EXPECT_NEAR(estimate.covariance(0, 0), second, 0.0004);
}

TEST(ParticleFilter, KeepsWeightsUntilTooFewParticlesCount) {
  const auto recording = std::make_shared<Recording>();
  ParticleFilter filter = makeFilter(recording, true);
  filter.reset(at(1.0, 0.05));
  filter.update({}, Observations{});
  const Eigen::ArrayXd weights = filter.hypotheses().log_weight;
  EXPECT_GT(weights.maxCoeff() - weights.minCoeff(), 1e-3);  // not resampled
  filter.reset(at(3.0, 1.0));
  filter.update({}, Observations{});
  const Eigen::ArrayXd resampled = filter.hypotheses().log_weight;
  EXPECT_NEAR(resampled.maxCoeff(), resampled.minCoeff(), 1e-12);
}

TEST(ParticleFilter, StartsAnewWithAsManyParticlesAsTheNewBeliefNeeds) {
  SampleSizeOptions sizes;
  sizes.min_particles = 50;
  sizes.max_particles = 3000;
  sizes.kld_count = "resampled";
  ParticleFilterParts parts;
  parts.motion = std::make_unique<DifferentialDrive>(MotionOptions{});
  parts.observation = std::make_unique<HillModel>();
  parts.resampling = systematicIndices;
  parts.size = kldSampleSize(sizes);
  parts.exploration = noExploration();
  parts.elsewhere = std::make_unique<FreeSpaceSampler>(asymmetricWorld());
  ParticleFilterOptions options;
  options.selective_resampling = false;
  ParticleFilter filter(options, std::move(parts), 1);
  filter.reset(at(1.0, 0.01));
  for (int i = 0; i < 3; ++i) filter.update({}, Observations{});
  ASSERT_LT(filter.hypotheses().size(), 500);
  filter.reset(Anywhere{});
  filter.update({}, Observations{});
  EXPECT_EQ(filter.hypotheses().size(), 3000);
}

}  // namespace
}  // namespace adaptive_localization
