// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/particle/kidnap_test.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kTruth{1.0, 1.0, 0.3};
const Pose2 kElsewhere{7.5, 4.1, 2.0};

KidnapOptions options() {
  KidnapOptions options;
  options.kidnap_mean_abs_error = 0.16;
  options.kidnap_truncation = 0.25;
  options.kidnap_unusual = 2.0;
  options.kidnap_confirm_scans = 2;
  options.kidnap_ratio = 2.5;
  options.local_share = 0.7;
  return options;
}

KidnapOptions sourceOptions() {
  KidnapOptions source = options();
  source.kidnap_mean_abs_error = 0.74;
  source.kidnap_truncation = 1000.0;
  source.kidnap_confirm_scans = 1;
  source.kidnap_unusual = 0.0;
  source.kidnap_ratio = 0.0;
  source.kidnap_arm_spread = 0.14;
  return source;
}

/// The first so many of 100 beams end 0.3 m before the laser.
Observations seenFrom(const Pose2& pose, int covered = 0) {
  Observations seen = ToyLaser{100, -2.0, 2.0, 12.0}.observe(asymmetricWorld(), pose);
  seen.scan.range.head(covered).setConstant(0.3F);
  return seen;
}

class KidnapTestTest : public testing::Test {
 protected:
  void use(const KidnapOptions& options) {
    test_ = kidnapTest(options, asymmetricWorld(), [this](const Observations&) {
      ++searches_;
      return places_;
    });
  }

  /// Tells of a scan and of the best particle, and whether that may weigh the particles.
  bool tell(const Observations& seen, const Pose2& best, double spread = 0.05,
            Eigen::Index particles = 500) {
    return test_->observe({seen, motion_, 0.5, best, spread, particles});
  }

  std::unique_ptr<Exploration> test_;
  std::vector<Pose2> places_;
  int searches_{0};
  Pose2 motion_;  // from scan to scan
};

TEST_F(KidnapTestTest, LooksNowhereWhileTheBestParticleExplainsTheScans) {
  use(options());
  places_ = {kTruth};
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(tell(seenFrom(kTruth), {1.03, 0.98, 0.31}));
  EXPECT_EQ(test_->share(), 0.0);
  EXPECT_EQ(searches_, 0);
}

TEST_F(KidnapTestTest, LooksElsewhereWhenScansAreUnexplainedHereAndExplainedThere) {
  use(options());
  places_ = {kTruth, kElsewhere};
  tell(seenFrom(kTruth), kTruth);
  EXPECT_EQ(searches_, 0);
  tell(seenFrom(kElsewhere), kTruth);
  EXPECT_EQ(test_->share(), 0.0);  // one scan is no proof
  tell(seenFrom(kElsewhere), kTruth);
  EXPECT_NEAR(test_->share(), 0.3, 1e-12);
  test_->explored();
  EXPECT_EQ(test_->share(), 0.0);
  tell(seenFrom(kElsewhere), kElsewhere);
  EXPECT_EQ(test_->share(), 0.0);
}

TEST_F(KidnapTestTest, ThePlaceElsewhereMovesWithTheOdometry) {
  const Pose2 later = kElsewhere * Pose2{-0.4, 0.0, 0.2};
  for (const bool moves : {true, false}) {
    use(options());
    motion_ = moves ? Pose2{-0.4, 0.0, 0.2} : Pose2{};
    places_ = {kElsewhere};
    tell(seenFrom(kElsewhere), kTruth);
    tell(seenFrom(later), kTruth);
    EXPECT_EQ(test_->share() > 0.0, moves);
  }
}

TEST_F(KidnapTestTest, CountsScansInARow) {
  use(options());
  places_ = {kElsewhere};
  for (int i = 0; i < 6; ++i) {
    tell(seenFrom(i % 2 ? kTruth : kElsewhere), kTruth);
    EXPECT_EQ(test_->share(), 0.0) << i;
  }
}

TEST_F(KidnapTestTest, StaysWhereNothingElsewhereIsBetter) {
  use(options());
  for (const auto& places : {std::vector<Pose2>{}, {kTruth}, {Pose2{3.0, 0.8, 2.0}}}) {
    places_ = places;
    searches_ = 0;
    test_->reset();
    for (int i = 0; i < 10; ++i) {
      tell(seenFrom(kElsewhere), kTruth);
      EXPECT_EQ(test_->share(), 0.0) << i;
    }
    EXPECT_EQ(searches_, 4);  // each third scan
  }
}

TEST_F(KidnapTestTest, ASmallErrorMayBeUnusual) {
  const Pose2 beside = kTruth * Pose2{0.06, 0.05, 0.0};
  for (const double unusual : {2.0, 0.0}) {
    KidnapOptions changed = options();
    changed.kidnap_unusual = unusual;
    use(changed);
    places_ = {kTruth};
    for (int i = 0; i < 20; ++i) tell(seenFrom(kTruth), kTruth);
    for (int i = 0; i < 3; ++i) tell(seenFrom(kTruth), beside);
    EXPECT_EQ(test_->share() > 0.0, unusual > 0.0);
  }
}

TEST_F(KidnapTestTest, AThirdOfTheBeamsMayBeBlocked) {
  use(options());
  places_ = {kTruth, kElsewhere};
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(tell(seenFrom(kTruth), kTruth));
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(tell(seenFrom(kTruth, 33), kTruth));
    EXPECT_EQ(test_->share(), 0.0);
  }
}

TEST_F(KidnapTestTest, ACoveredLaserWeighsNothingIfScansWereExplainedBefore) {
  use(options());
  EXPECT_TRUE(tell(seenFrom(kTruth, 90), kTruth));  // a robot that may be anywhere
  EXPECT_TRUE(tell(seenFrom(kTruth), kTruth));
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(tell(seenFrom(kTruth, 90), kTruth));
  EXPECT_EQ(test_->share(), 0.0);
  EXPECT_TRUE(tell(seenFrom(kTruth, 50), kTruth));  // half of it is still worth something
  EXPECT_TRUE(tell(seenFrom(kTruth), kTruth));
  test_->reset();
  EXPECT_TRUE(tell(seenFrom(kTruth, 90), kTruth));
}

TEST_F(KidnapTestTest, OfTheSourceAsksForNoOtherPlace) {
  use(sourceOptions());
  tell(seenFrom(kTruth), kTruth);
  EXPECT_EQ(test_->share(), 0.0);
  EXPECT_TRUE(tell(seenFrom(kElsewhere), kTruth));
  EXPECT_NEAR(test_->share(), 0.3, 1e-12);
  EXPECT_EQ(searches_, 0);
}

TEST_F(KidnapTestTest, OfTheSourceIsArmedByConvergence) {
  KidnapOptions few = sourceOptions();
  few.kidnap_arm_particles = 1000;
  use(few);
  tell(seenFrom(kElsewhere), kTruth, 2.0, 500);
  EXPECT_EQ(test_->share(), 0.0);
  tell(seenFrom(kElsewhere), kTruth, 0.05, 2000);
  EXPECT_EQ(test_->share(), 0.0);
  tell(seenFrom(kElsewhere), kTruth, 0.05, 500);
  EXPECT_GT(test_->share(), 0.0);
  tell(seenFrom(kElsewhere), kTruth, 2.0, 2000);  // once armed, it stays so
  EXPECT_GT(test_->share(), 0.0);
  test_->reset();
  tell(seenFrom(kElsewhere), kTruth, 2.0, 500);
  EXPECT_EQ(test_->share(), 0.0);
}

TEST_F(KidnapTestTest, ScansWithoutHitsTellNothing) {
  use(options());
  places_ = {kElsewhere};
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(tell(Observations{}, kTruth));
  EXPECT_EQ(test_->share(), 0.0);
  EXPECT_EQ(searches_, 0);
}

TEST_F(KidnapTestTest, OutlivesPosesThatAreNoNumbers) {
  use(options());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  places_ = {{nan, nan, nan}, kElsewhere};
  for (int i = 0; i < 2; ++i) tell(seenFrom(kElsewhere), {nan, 1.0, nan});
  EXPECT_GT(test_->share(), 0.0);
}

}  // namespace
}  // namespace adaptive_localization
