// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/particle/resampling.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "adaptive_localization/filters/builtins.hpp"

namespace adaptive_localization {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInf = std::numeric_limits<double>::infinity();

Eigen::ArrayXd column(std::initializer_list<double> values) {
  Eigen::ArrayXd array(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), array.data());
  return array;
}

Eigen::ArrayXd randomWeights(Rng& rng, Eigen::Index count) {
  Eigen::ArrayXd weights(count);
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    weights[i] = rng.uniform() < 0.2 ? 0.0 : std::exp(rng.normal(0.0, 2.0));
  }
  weights[0] += 1e-3;
  return weights / weights.sum();
}

Eigen::ArrayXd countsOf(const std::vector<Eigen::Index>& indices, Eigen::Index size) {
  Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(size);
  for (const Eigen::Index i : indices) counts[i] += 1.0;
  return counts;
}

TEST(NormalisedWeights, SumToOneAndKeepRatios) {
  const Eigen::ArrayXd weights = normalisedWeights(column({-1000.0, -1000.0 + std::log(3.0)}));
  EXPECT_NEAR(weights[0], 0.25, 1e-12);
  EXPECT_NEAR(weights[1], 0.75, 1e-12);
  EXPECT_NEAR(normalisedWeights(column({700.0, 710.0, -kInf})).sum(), 1.0, 1e-12);
  EXPECT_NEAR(normalisedWeights(column({0.0, -kInf}))[1], 0.0, 1e-300);
}

TEST(NormalisedWeights, AreUniformWhereTheyMakeNoSense) {
  for (const auto& senseless :
       {column({-kInf, -kInf}), column({kNan, 0.0}), column({0.0, kNan}), column({kInf, 0.0})}) {
    EXPECT_TRUE((normalisedWeights(senseless) == 0.5).all()) << senseless;
  }
  EXPECT_EQ(normalisedWeights(column({})).size(), 0);
  EXPECT_EQ(normalisedWeights(column({-kInf}))[0], 1.0);
}

TEST(EffectiveSize, IsBetweenOneAndTheNumber) {
  EXPECT_NEAR(effectiveSize(Eigen::ArrayXd::Constant(40, 1.0 / 40.0)), 40.0, 1e-9);
  EXPECT_DOUBLE_EQ(effectiveSize(column({1.0, 0.0, 0.0})), 1.0);
  EXPECT_DOUBLE_EQ(effectiveSize(column({0.5, 0.5, 0.0})), 2.0);
}

TEST(SystematicIndices, DrawEachParticleFloorOrCeilOfItsShare) {
  Rng rng(1);
  for (int trial = 0; trial < 500; ++trial) {
    const auto size = static_cast<Eigen::Index>(1 + rng.below(50));
    const auto count = static_cast<Eigen::Index>(1 + rng.below(200));
    const Eigen::ArrayXd weights = randomWeights(rng, size);
    const auto indices = systematicIndices(weights, count, rng);
    ASSERT_EQ(indices.size(), static_cast<std::size_t>(count));
    ASSERT_TRUE(std::is_sorted(indices.begin(), indices.end()));
    const Eigen::ArrayXd drawn = countsOf(indices, size);
    const Eigen::ArrayXd share = weights * static_cast<double>(count);
    ASSERT_TRUE((drawn >= (share - 1e-9).floor()).all()) << drawn << "\n" << share;
    ASSERT_TRUE((drawn <= (share + 1e-9).ceil()).all()) << drawn << "\n" << share;
  }
}

TEST(StratifiedIndices, DrawEachParticleWithinOneOfItsShare) {
  Rng rng(4);
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::ArrayXd weights = randomWeights(rng, 30);
    const auto count = static_cast<Eigen::Index>(1 + rng.below(200));
    const Eigen::ArrayXd drawn = countsOf(stratifiedIndices(weights, count, rng), 30);
    const Eigen::ArrayXd share = weights * static_cast<double>(count);
    ASSERT_LT((drawn - share).abs().maxCoeff(), 2.0);
  }
}

TEST(MultinomialIndices, VaryAsIndependentDrawsDo) {
  Rng rng(5);
  constexpr int kRounds = 20000;
  constexpr double kCount = 40.0;
  const Eigen::ArrayXd weights = column({0.1, 0.6, 0.3});
  Eigen::ArrayXd variance = Eigen::ArrayXd::Zero(3);
  for (int i = 0; i < kRounds; ++i) {
    const auto drawn = countsOf(multinomialIndices(weights, 40, rng), 3);
    variance += (drawn - kCount * weights).square() / kRounds;
  }
  const Eigen::ArrayXd expected = kCount * weights * (1.0 - weights);
  EXPECT_LT((variance / expected - 1.0).abs().maxCoeff(), 0.05);
}

class EveryScheme : public testing::TestWithParam<std::string> {
 protected:
  const Resampling draw_ = builtins().resamplings.make(GetParam(), Parameters{});
};
INSTANTIATE_TEST_SUITE_P(Resampling, EveryScheme,
                         testing::ValuesIn(builtins().resamplings.names()));

TEST_P(EveryScheme, IsUnbiased) {
  Rng rng(2);
  const Eigen::ArrayXd weights = randomWeights(rng, 20);
  constexpr int kRounds = 20000;
  constexpr Eigen::Index kCount = 33;
  Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(20);
  for (int i = 0; i < kRounds; ++i) mean += countsOf(draw_(weights, kCount, rng), 20) / kRounds;
  // of independent draws, which vary most: the variance of a count is at most its share
  const Eigen::ArrayXd four_deviations = 4.0 * (weights * kCount / kRounds).sqrt();
  EXPECT_TRUE(((mean - weights * kCount).abs() <= four_deviations).all());
}

TEST_P(EveryScheme, TakesEdgeCases) {
  Rng rng(3);
  EXPECT_TRUE(draw_(column({}), 5, rng).empty());
  EXPECT_TRUE(draw_(column({1.0}), 0, rng).empty());
  EXPECT_THAT(draw_(column({1.0}), 3, rng), testing::ElementsAre(0, 0, 0));
  EXPECT_THAT(draw_(column({0.0, 1.0, 0.0}), 2, rng), testing::ElementsAre(1, 1));
  for (const Eigen::Index i : draw_(column({kNan, kNan}), 100, rng)) {
    ASSERT_TRUE(i == 0 || i == 1);
  }
}

TEST(TemperedWeights, AreBayesRuleWhereTheLikelihoodIsBlunt) {
  const Eigen::ArrayXd weights = normalisedWeights(Eigen::ArrayXd::LinSpaced(100, 0.0, 2.0));
  const Eigen::ArrayXd gentle = Eigen::ArrayXd::LinSpaced(100, 1.0, 0.0);
  const Eigen::ArrayXd product = weights * gentle.exp();
  const Eigen::ArrayXd expected = product / product.sum();
  EXPECT_LT((temperedWeights(weights, gentle, 0.1) - expected).abs().maxCoeff(), 1e-12);
  const Eigen::ArrayXd sharp = temperedWeights(weights, 1000.0 * gentle, 0.0);
  EXPECT_GT(sharp[0], 0.99);  // never tempered
}

TEST(TemperedWeights, KeepTheShareOfEffectiveParticles) {
  const Eigen::ArrayXd flat = Eigen::ArrayXd::Constant(1000, 1e-3);
  const Eigen::ArrayXd weights =
      temperedWeights(flat, Eigen::ArrayXd::LinSpaced(1000, 0.0, 5000.0), 0.1);
  EXPECT_NEAR(effectiveSize(weights), 100.0, 25.0);
  EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
}

TEST(TemperedWeights, CountWhatWasEffectiveBefore) {
  Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(100, 1e-12);
  weights[3] = 1.0 - 99e-12;  // one particle is left: none can be lost
  const Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::LinSpaced(100, 0.0, 10.0);
  EXPECT_GT(temperedWeights(weights, log_likelihood, 0.5)[3], 0.99);
}

TEST(Select, CopiesPosesAndMakesWeightsEqual) {
  Particles particles(3);
  for (Eigen::Index i = 0; i < 3; ++i) particles.setPose(i, {1.0 * double(i), 2.0, 3.0});
  particles.log_weight << -1.0, -2.0, -3.0;
  const Particles selected = select(particles, {2, 0, 2});
  EXPECT_TRUE((selected.x == column({2.0, 0.0, 2.0})).all());
  EXPECT_TRUE((selected.log_weight == selected.log_weight[0]).all());
}

}  // namespace
}  // namespace adaptive_localization
