// SPDX-License-Identifier: BSD-3-Clause
#include "particle/kidnap_test.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kTruth{1.0, 1.0, 0.3};
const Pose2 kElsewhere{7.5, 4.1, 2.0};

KidnapOptions sourceOptions() {
  KidnapOptions source;
  source.kidnap_mean_abs_error = 0.74;
  source.kidnap_arm_spread = 0.14;
  source.local_share = 0.7;
  return source;
}

class KidnapTestTest : public testing::Test {
 protected:
  /// Tells of a scan and of the best particle.
  void tell(const Pose2& truth, const Pose2& best, double spread = 0.05,
            Eigen::Index particles = 500) {
    const Observations seen = ToyLaser{100, -2.0, 2.0, 12.0}.observe(asymmetricWorld(), truth);
    test_->observe({seen, 0.5, best, spread, particles});
  }

  std::unique_ptr<Exploration> test_ = kidnapTest(sourceOptions(), asymmetricWorld());
};

TEST_F(KidnapTestTest, LooksElsewhereAsLongAsTheBestParticleDoesNotExplainTheScan) {
  tell(kTruth, kTruth);
  EXPECT_EQ(test_->share(), 0.0);
  for (int scan = 0; scan < 3; ++scan) {
    tell(kElsewhere, kTruth);
    EXPECT_DOUBLE_EQ(test_->share(), 1.0 - 0.7);
  }
  tell(kElsewhere, kElsewhere);
  EXPECT_EQ(test_->share(), 0.0);
}

TEST_F(KidnapTestTest, LooksOnceForEachScan) {
  tell(kTruth, kTruth);
  tell(kElsewhere, kTruth);
  test_->explored();
  EXPECT_EQ(test_->share(), 0.0);
}

TEST_F(KidnapTestTest, IsArmedOnceTheParticlesHadConverged) {
  tell(kElsewhere, kTruth, 2.0);
  EXPECT_EQ(test_->share(), 0.0);
  tell(kTruth, kTruth, 0.1);
  tell(kElsewhere, kTruth, 2.0);
  EXPECT_GT(test_->share(), 0.0);
  test_->reset();
  tell(kElsewhere, kTruth, 2.0);
  EXPECT_EQ(test_->share(), 0.0);
}

TEST_F(KidnapTestTest, IsArmedOnceThereWereFewParticles) {
  KidnapOptions options = sourceOptions();
  options.kidnap_arm_spread = 0.0;
  options.kidnap_arm_particles = 1000;
  test_ = kidnapTest(options, asymmetricWorld());
  tell(kElsewhere, kTruth, 2.0, 5000);
  EXPECT_EQ(test_->share(), 0.0);
  tell(kElsewhere, kTruth, 2.0, 999);
  EXPECT_GT(test_->share(), 0.0);
}

TEST_F(KidnapTestTest, IsOffWithoutAThreshold) {
  test_ = kidnapTest(KidnapOptions{}, asymmetricWorld());
  tell(kElsewhere, kTruth);
  EXPECT_EQ(test_->share(), 0.0);
}

TEST_F(KidnapTestTest, AScanWithoutHitsTellsNothing) {
  tell(kTruth, kTruth);
  test_->observe({Observations{}, 0.5, kTruth, 0.05, 500});
  EXPECT_EQ(test_->share(), 0.0);
}

TEST_F(KidnapTestTest, ABestParticleThatIsNowhereExplainsNothing) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  tell(kTruth, kTruth);
  tell(kTruth, {kNaN, 1.0, 0.0});
  EXPECT_GE(test_->share(), 0.0);
  EXPECT_LE(test_->share(), 1.0);
}

}  // namespace
}  // namespace adaptive_localization
