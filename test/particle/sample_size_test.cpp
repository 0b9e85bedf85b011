// SPDX-License-Identifier: BSD-3-Clause
#include "particle/sample_size.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

SampleSizeOptions sizes() {
  SampleSizeOptions options;
  options.min_particles = 100;
  options.max_particles = 5000;
  options.kld_err = 0.02;
  options.kld_z = 2.33;
  options.kld_bin_xy = 0.5;
  options.kld_bin_theta = kPi / 18.0;
  options.kld_count = "drawn";
  return options;
}

Particles cloud(Eigen::Index count, double side, std::uint64_t seed = 1) {
  Rng rng(seed);
  Particles particles(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Pose2 pose = randomPose(rng, side);
    pose.theta *= std::min(1.0, side);
    particles.setPose(i, pose);
  }
  return particles;
}

/// Draws poses one bin apart, each in a bin of its own.
class Staircase : public PoseSampler {
 public:
  Pose2 draw(Rng&) const override { return {1000.0 + ++drawn_, 0.0, 0.0}; }

 private:
  mutable double drawn_{0.0};
};

/// A cloud of equal weights, and with some probability a pose elsewhere.
struct Believer {
  const Particles& particles;
  Eigen::ArrayXd weights;
  Staircase sampler;
  double elsewhere;
  operator Belief() const { return {particles, weights, sampler, elsewhere}; }
};

Believer believe(const Particles& particles, double elsewhere = 0.0) {
  const auto count = static_cast<double>(particles.size());
  return {particles, Eigen::ArrayXd::Constant(particles.size(), 1.0 / count), {}, elsewhere};
}

TEST(KldSampleSize, HasTheValuesOfFoxsFormula) {
  EXPECT_EQ(kldSampleSize(2, 0.02, 2.33), 166);
  EXPECT_EQ(kldSampleSize(3, 0.02, 2.33), 232);
  EXPECT_EQ(kldSampleSize(5, 0.02, 2.33), 334);
  EXPECT_EQ(kldSampleSize(31, 0.02, 2.33), 1274);
  EXPECT_EQ(kldSampleSize(65, 0.02, 2.33), 2333);
  EXPECT_EQ(kldSampleSize(97, 0.02, 2.33), 3281);
}

TEST(KldSampleSize, IsOneForOneBinAndGrowsWithBins) {
  EXPECT_EQ(kldSampleSize(0, 0.02, 2.33), 1);
  EXPECT_EQ(kldSampleSize(1, 0.02, 2.33), 1);
  for (int bins = 1; bins < 1000; ++bins) {
    ASSERT_LT(kldSampleSize(bins, 0.02, 2.33), kldSampleSize(bins + 1, 0.02, 2.33));
  }
}

/// Uniform over so many bins in a row.
class Row : public PoseSampler {
 public:
  explicit Row(int bins) : bins_(bins) {}
  Pose2 draw(Rng& rng) const override { return {rng.uniform(0.0, 0.5 * bins_), 0.25, 0.1}; }

 private:
  double bins_;
};

TEST(FixedSampleSize, IsAlwaysTheSame) {
  Rng rng(1);
  const auto size = fixedSampleSize(sizes());
  const Particles particles = cloud(50, 5.0);
  EXPECT_EQ(size->initial(), 5000);
  EXPECT_EQ(size->initial(Row{3}, rng), 5000);
  EXPECT_EQ(size->next(believe(particles), rng), 5000);
}

TEST(KldDrawn, AsksForFewWhereTheBeliefIsNarrowAndManyWhereItIsWide) {
  Rng rng(1);
  const auto size = kldSampleSize(sizes());
  const Particles narrow = cloud(3000, 0.01), medium = cloud(3000, 0.6), wide = cloud(3000, 20.0);
  const Eigen::Index few = size->next(believe(narrow), rng);
  const Eigen::Index some = size->next(believe(medium), rng);
  EXPECT_LT(few, 500);  // 8 bins meet at zero
  EXPECT_GT(some, few);
  EXPECT_EQ(size->next(believe(wide), rng), 5000);
}

TEST(KldDrawn, AsksForTheNumberThatItsBinsDemand) {
  Rng rng(2);
  Particles particles(310);  // 31 equally heavy bins
  for (Eigen::Index i = 0; i < 310; ++i) {
    particles.setPose(i, {0.25 + double(i % 31), 0.25, 0.01});
  }
  EXPECT_EQ(kldSampleSize(sizes())->next(believe(particles), rng), 1274);
}

TEST(KldDrawn, DoesNotCountParticlesWithoutWeight) {
  Rng rng(3);
  const Particles particles = cloud(1000, 20.0);
  Eigen::ArrayXd weights = Eigen::ArrayXd::Zero(1000);
  weights[500] = 1.0;
  EXPECT_EQ(kldSampleSize(sizes())->next({particles, weights, Staircase(), 0.0}, rng), 100);
}

TEST(KldDrawn, StaysInsideItsLimits) {
  SampleSizeOptions options = sizes();
  options.min_particles = options.max_particles = 321;
  Rng rng(4);
  for (const double side : {0.01, 1.0, 30.0}) {
    const Particles particles = cloud(200, side);
    EXPECT_EQ(kldSampleSize(options)->next(believe(particles), rng), 321);
  }
}

TEST(KldResampled, SizesTheNextSetByTheLast) {
  SampleSizeOptions options = sizes();
  options.kld_count = "resampled";
  const auto size = kldSampleSize(options);
  Rng rng(5);
  Particles particles(31);
  for (Eigen::Index i = 0; i < 31; ++i) particles.setPose(i, {0.25 + double(i), 0.25, 0.01});
  EXPECT_EQ(size->initial(), 5000);
  size->observe(particles);
  EXPECT_EQ(size->next(believe(particles), rng), 1274);
}

TEST(KldSampleSize, StartsInARegionWithAsManyAsItsBinsAskFor) {
  Rng rng(7);
  for (const std::string count : {"drawn", "resampled"}) {
    SampleSizeOptions options = sizes();
    options.kld_count = count;
    const auto size = kldSampleSize(options);
    EXPECT_EQ(size->initial(Row{31}, rng), 1274) << count;  // the numbers of SA-KLD's source
    EXPECT_EQ(size->initial(Row{65}, rng), 2333) << count;
    EXPECT_EQ(size->initial(Row{97}, rng), 3281) << count;
    EXPECT_EQ(size->initial(Staircase(), rng), 5000) << count;
  }
}

TEST(KldResampled, SizesASetThatLooksElsewhereByTheBinsThere) {
  SampleSizeOptions options = sizes();
  options.kld_count = "resampled";
  const auto size = kldSampleSize(options);
  Rng rng(8);
  const Particles narrow = cloud(1000, 0.01);
  size->observe(narrow);
  ASSERT_LT(size->next(believe(narrow), rng), 500);
  EXPECT_EQ(size->next({narrow, believe(narrow).weights, Row{31}, 0.3}, rng), 1274);
  EXPECT_LT(size->next(believe(narrow), rng), 500);
}

TEST(KldSampleSizeOptions, RefuseAMinimumAboveTheMaximum) {
  SampleSizeOptions options = sizes();
  options.min_particles = 6000;
  try {
    kldSampleSize(options);
    FAIL() << "took a minimum above the maximum";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("min_particles"), testing::HasSubstr("6000"),
                               testing::HasSubstr("5000")));
  }
}

TEST(KldSampleSize, CountsTheBinsOfPosesElsewhere) {
  Rng rng(6);
  const Particles narrow = cloud(1000, 0.01);
  const auto size = kldSampleSize(sizes());
  const Eigen::Index here = size->next(believe(narrow), rng);
  EXPECT_GT(size->next(believe(narrow, 0.1), rng), 2 * here);
  EXPECT_EQ(size->next(believe(narrow, 1.0), rng), 5000);
}

}  // namespace
}  // namespace adaptive_localization
