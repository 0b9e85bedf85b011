// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "../../src/eval/accuracy_judge.hpp"
#include "eval/experiment_run.hpp"
#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

/// An estimate with standard deviations of 0.1 m and 0.1 rad.
Localization answerAt(const Pose2& pose, bool updated = true) {
  Localization answer;
  answer.T_map_base = answer.estimate.T_map_base = pose;
  answer.estimate.covariance = 0.01 * Eigen::Matrix3d::Identity();
  answer.updated = updated;
  return answer;
}

TEST(Accuracy, IsTheMeanErrorAndTheMeanNormalisedError) {
  AccuracyJudge judge;
  judge.observe(1.0, answerAt({0.1, 0.0, 0.0}), {}, std::nullopt);  // one standard deviation
  judge.observe(1.5, answerAt({0.3, 0.0, 0.0}, false), {}, std::nullopt);
  judge.observe(1.6, answerAt({0.2, 0.0, kPi / 18.0}), {0.2, 0.0, kPi / 18.0}, std::nullopt);
  judge.observe(3.2, answerAt({0.0, 0.2, 0.0}), {}, std::nullopt);  // two
  const Accuracy accuracy = judge.finish();
  EXPECT_EQ(accuracy.scans, 4);
  EXPECT_NEAR(accuracy.mean_m, (0.1 + 0.3 + 0.0 + 0.2) / 4.0, 1e-12);
  EXPECT_NEAR(accuracy.mean_deg, 0.0, 1e-9);
  ASSERT_TRUE(accuracy.normalized_mean);
  EXPECT_NEAR(*accuracy.normalized_mean, (1.0 + 0.0 + 4.0) / 3.0, 1e-9) << "at updates";
  ASSERT_EQ(accuracy.normalized.size(), 4U);
  EXPECT_NEAR(accuracy.normalized[1].value(), 1.0, 1e-9) << "the first one of the second";
  EXPECT_FALSE(accuracy.normalized[0] || accuracy.normalized[2]);
  EXPECT_NEAR(accuracy.normalized[3].value(), 4.0, 1e-9);
  EXPECT_FALSE(accuracy.scan_bound_m) << "nobody asked";
}

TEST(Accuracy, TakesRootMeanSquaresOfBounds) {
  AccuracyJudge judge;
  judge.observe(1.0, answerAt({}), {}, ScanBounds{{0.03, 0.2}, {0.01, 0.1}});
  judge.observe(1.1, answerAt({}), {}, ScanBounds{{0.04, 0.2}, {0.01, 0.1}});
  const Accuracy accuracy = judge.finish();
  EXPECT_NEAR(accuracy.scan_bound_m.value(), 0.05 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(accuracy.scan_bound_deg.value(), 0.2 * 180.0 / kPi, 1e-9);
  EXPECT_NEAR(accuracy.drive_bound_m.value(), 0.01, 1e-12);
  EXPECT_NEAR(accuracy.drive_bound_deg.value(), 0.1 * 180.0 / kPi, 1e-9);
}

TEST(Accuracy, OfNothingIsNothing) {
  const Accuracy accuracy = AccuracyJudge().finish();
  EXPECT_EQ(accuracy.scans, 0);
  EXPECT_FALSE(accuracy.normalized_mean || accuracy.scan_bound_m);
}

TEST(Accuracy, OfADriveIsAboveItsBound) {
  const ToyExperiment toy;
  const ExperimentCase of_case =
      toy.load(
             "start_known: true\nstart: [1, 0.6, 0]\nduration: 4\nbounds: true\n"
             "simulation: {laser_noise: 0.03, laser_bias: 0}\n"
             "options: {update_min_d: 0, update_min_a: 0}\n")
          .cases.front();
  const auto result = runExperiment(loadSite(of_case), of_case, of_case.cores.front(), 1);
  const Accuracy& accuracy = result.accuracy;
  EXPECT_EQ(accuracy.scans, 38) << "from the third that is right";
  ASSERT_TRUE(accuracy.scan_bound_m && accuracy.drive_bound_m && accuracy.normalized_mean);
  EXPECT_GT(*accuracy.scan_bound_m, 1e-3);
  EXPECT_LT(*accuracy.scan_bound_m, 0.05);
  EXPECT_LT(*accuracy.drive_bound_m, *accuracy.scan_bound_m);
  EXPECT_GT(result.rms_m, *accuracy.drive_bound_m);
  EXPECT_GT(result.rms_deg, *accuracy.drive_bound_deg);
  EXPECT_LT(accuracy.mean_m, result.rms_m + 1e-12);
  EXPECT_GT(*accuracy.normalized_mean, 0.0);
}

}  // namespace
}  // namespace adaptive_localization
