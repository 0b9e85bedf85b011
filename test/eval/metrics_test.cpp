// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics.hpp"

#include <gmock/gmock.h>

#include "eval/statistics.hpp"

namespace adaptive_localization {
namespace {

constexpr double kDegree = kPi / 180.0;

/// A step whose estimate is off by `error` metres and `heading` radians.
RunStep step(double stamp, double error, double heading = 0.0) {
  RunStep result;
  result.stamp = stamp;
  result.T_odom_base = {2.0 * stamp, 0.0, 0.0};
  result.T_map_base_reference = Pose2{stamp, 5.0, 3.0};
  result.T_map_base = {stamp, 5.0 + error, wrapAngle(3.0 + heading)};
  return result;
}

ErrorMetrics errorsOf(std::vector<RunStep> steps) {
  RunRecord run;
  run.steps = std::move(steps);
  return *measure(run).errors;
}

TEST(Quantile, InterpolatesBetweenRanks) {
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(quantile({7.0}, 0.95), 7.0);
  EXPECT_DOUBLE_EQ(quantile({}, 0.5), 0.0);
}

/// So many updates with each status, and a scan between them that made none.
Metrics afterUpdates(int tracking, int ambiguous, int globalizing, int lost) {
  RunRecord run;
  const auto add = [&run](int count, Status status) {
    for (int i = 0; i < 2 * count; ++i) {
      run.steps.push_back(step(static_cast<double>(run.steps.size()), 0.0));
      run.steps.back().updated = i % 2 == 0;
      run.steps.back().status = i % 2 == 0 ? status : Status::kUninitialised;
    }
  };
  add(tracking, Status::kTracking);
  add(ambiguous, Status::kAmbiguous);
  add(globalizing, Status::kGlobalizing);
  add(lost, Status::kLost);
  return measure(run);
}

TEST(Metrics, TellsWhatTheLocalizerSaidAtUpdates) {
  const Metrics metrics = afterUpdates(5, 2, 1, 2);
  EXPECT_DOUBLE_EQ(metrics.tracking_share, 0.5);
  EXPECT_DOUBLE_EQ(metrics.nowhere_share, 0.3);
  EXPECT_DOUBLE_EQ(Metrics{}.tracking_share, 0.0);
}

TEST(Metrics, MisfitIsToBeNowhereAndHardlyEverTracked) {
  EXPECT_TRUE(isMisfit(afterUpdates(0, 0, 0, 10)));
  EXPECT_TRUE(isMisfit(afterUpdates(0, 5, 5, 0)));
  EXPECT_TRUE(isMisfit(afterUpdates(1, 70, 20, 9)));
  EXPECT_FALSE(isMisfit(afterUpdates(1, 0, 0, 9))) << "found in the end";
  EXPECT_FALSE(isMisfit(afterUpdates(0, 96, 0, 4))) << "a poor map, but the right one";
  EXPECT_FALSE(isMisfit(afterUpdates(0, 0, 0, 0))) << "nothing is known";
}

TEST(Metrics, TakesErrorsAtEveryScan) {
  auto steps = std::vector<RunStep>{step(0, 0.0), step(1, 0.1), step(2, -0.2), step(3, 0.2)};
  steps[1].updated = true;
  const ErrorMetrics errors = errorsOf(steps);
  EXPECT_NEAR(errors.ate_rmse_m, 0.15, 1e-12);
  EXPECT_NEAR(errors.ate_mean_m, 0.125, 1e-12);
  EXPECT_NEAR(errors.ate_median_m, 0.15, 1e-12);
  EXPECT_NEAR(errors.ate_p95_m, 0.2, 1e-12);
  EXPECT_NEAR(errors.ate_max_m, 0.2, 1e-12);
  EXPECT_NEAR(errors.final_error_m, 0.2, 1e-12);
}

TEST(Metrics, TellsWhetherCovariancesMeanWhatTheySay) {
  auto steps = std::vector<RunStep>{step(0, 0.0), step(1, 0.1), step(2, -0.2), step(3, 0.4)};
  EXPECT_FALSE(errorsOf(steps).nees_mean) << "no covariance";
  for (auto& one : steps) one.covariance = 0.01 * Eigen::Matrix3d::Identity();
  EXPECT_FALSE(errorsOf(steps).nees_mean) << "no update";
  for (auto& one : steps) one.updated = true;
  const ErrorMetrics errors = errorsOf(steps);
  EXPECT_NEAR(errors.nees_mean.value(), (0.0 + 1.0 + 4.0 + 16.0) / 4.0, 1e-9);
  EXPECT_NEAR(errors.nees_median.value(), 2.5, 1e-9);
  EXPECT_NEAR(errors.nees_in_band.value(), 0.5, 1e-12) << "1 and 4 lie between 0.22 and 9.35";
}

TEST(Metrics, HoldErrorsAgainstConfidence) {
  auto steps = std::vector<RunStep>{step(0, 0.0), step(1, 0.1), step(2, -0.4), step(3, 0.2)};
  for (auto& one : steps) one.confidence = 0.95;
  steps[3].confidence = 0.5;
  const Calibration calibration = errorsOf(steps).calibration;
  EXPECT_EQ(calibration.scans[9], 3);
  EXPECT_EQ(calibration.near[9], 2);
  EXPECT_EQ(calibration.near[5], 1);
}

TEST(Metrics, TakesTheProcessorTimeOfUpdates) {
  RunRecord run;
  run.steps = {step(0, 0.0), step(1, 0.0), step(2, 0.0)};
  for (auto& one : run.steps) one.cpu_ms = 1.0 + one.stamp * one.stamp;
  run.steps[1].updated = run.steps[2].updated = true;
  EXPECT_NEAR(measure(run).update_cpu_ms_median, 3.5, 1e-12);
  EXPECT_NEAR(measure(run).update_cpu_ms_mean, 3.5, 1e-12);
}

TEST(Run, TakesVelocitiesFromOdometryBetweenScans) {
  Log log;
  for (const double x : {0.0, 0.1, 0.3, 9.0}) {
    LogScan scan;
    scan.scan.stamp = x < 9.0 ? 0.1 * static_cast<double>(log.scans.size()) : 60.0;
    scan.T_odom_base = {x, 0.0, 0.5 * x};
    log.scans.push_back(scan);
  }
  EXPECT_NEAR(velocityAt(log, 0).x, 1.0, 1e-12);
  EXPECT_NEAR(velocityAt(log, 0).turn, 0.5, 1e-12);
  EXPECT_GT(velocityAt(log, 1).x, 1.9);
  EXPECT_EQ(velocityAt(log, 2).x, velocityAt(log, 1).x) << "the next is a minute later";
  EXPECT_EQ(velocityAt(log, 3).x, 0.0);
}

TEST(Metrics, TakesHeadingTheShortWayRound) {
  const ErrorMetrics errors =
      errorsOf({step(0, 0.0, 10.0 * kDegree), step(1, 0.0, -350.0 * kDegree)});
  EXPECT_NEAR(errors.heading_rmse_deg, 10.0, 1e-9);
  EXPECT_NEAR(errors.final_heading_error_deg, 10.0, 1e-9);
}

TEST(Metrics, DoesNotAlignTheTrajectories) {
  EXPECT_NEAR(errorsOf({step(0, 3.0), step(1, 3.0)}).ate_rmse_m, 3.0, 1e-12);
}

TEST(Metrics, ConvergesWhereItStaysToTheEnd) {
  const ErrorMetrics errors =
      errorsOf({step(10, 2.0), step(11, 0.1), step(12, 0.6), step(13, 0.4), step(14, 0.1)});
  ASSERT_TRUE(errors.converged_at_s);
  EXPECT_NEAR(*errors.converged_at_s, 3.0, 1e-12);
  EXPECT_NEAR(errors.lost_share, 0.4, 1e-12);
}

TEST(Metrics, HeadingCountsForConvergence) {
  const ErrorMetrics errors =
      errorsOf({step(10, 0.1, 21.0 * kDegree), step(11, 0.1, 19.0 * kDegree)});
  ASSERT_TRUE(errors.converged_at_s);
  EXPECT_NEAR(*errors.converged_at_s, 1.0, 1e-12);
}

TEST(Metrics, NeverConvergesWhenLostAtTheEnd) {
  const ErrorMetrics errors = errorsOf({step(0, 0.0), step(1, 0.51)});
  EXPECT_FALSE(errors.converged_at_s);
  EXPECT_NEAR(errors.lost_share, 0.5, 1e-12);
}

TEST(Metrics, CountsWhereItSaysTrackingAndIsLost) {
  auto steps = std::vector<RunStep>{step(5, 9.0), step(6, 9.0), step(7, 0.1), step(8, 0.1)};
  steps[0].status = Status::kAmbiguous;
  for (std::size_t i = 1; i < steps.size(); ++i) steps[i].status = Status::kTracking;
  const ErrorMetrics errors = errorsOf(steps);
  EXPECT_NEAR(errors.lost_share, 0.5, 1e-12);
  EXPECT_NEAR(errors.misled_share, 0.25, 1e-12);
  ASSERT_TRUE(errors.tracking_at_s);
  EXPECT_NEAR(*errors.tracking_at_s, 1.0, 1e-12);
}

TEST(Metrics, KnowsTheLongestTimeOfTrackingThoughLost) {
  auto steps = std::vector<RunStep>{
      step(0, 0.0), step(1, 9.0), step(2, 0.0), step(4, 9.0), step(5, 0.0, 30.0 * kDegree),
      step(9, 9.0), step(20, 9.0)};
  for (auto& s : steps) s.status = Status::kTracking;
  steps[6].status = Status::kLost;
  EXPECT_NEAR(errorsOf(steps).misled_longest_s, 7.0, 1e-12) << "from 2, the last good answer, to 9";
  EXPECT_DOUBLE_EQ(errorsOf({step(0, 0.0), step(1, 0.0)}).misled_longest_s, 0.0);
}

TEST(Metrics, CountsWhereTheEstimateLeavesTheOdometry) {
  RunRecord run;
  for (int i = 0; i < 6; ++i) {
    run.steps.push_back(step(i, 0.0));
    run.steps.back().T_odom_base = {0.0, static_cast<double>(i), -0.5 * kPi};
    run.steps.back().T_map_base = {static_cast<double>(i), 0.0, kPi};
    run.steps.back().status = Status::kTracking;
  }
  EXPECT_EQ(measure(run).jumps, 0) << "frames of their own are no jumps";
  for (std::size_t i = 2; i < 6; ++i) run.steps[i].T_map_base.y += i < 4 ? 0.6 : 0.4;
  EXPECT_EQ(measure(run).jumps, 1) << "0.2 m is none";
  run.steps[1].status = Status::kUninitialised;
  EXPECT_EQ(measure(run).jumps, 0);
}

TEST(Metrics, HasNoErrorsWithoutReference) {
  RunRecord run;
  run.steps = {step(0, 0.0), step(1, 0.0), step(2, 0.0)};
  for (auto& s : run.steps) s.T_map_base_reference.reset();
  const Metrics metrics = measure(run);
  EXPECT_FALSE(metrics.errors);
  EXPECT_NEAR(metrics.path_m, 4.0, 1e-12) << "of the odometry";
  EXPECT_NEAR(metrics.duration_s, 2.0, 1e-12);
}

TEST(Metrics, LeavesOutScansWithoutReference) {
  auto steps = std::vector<RunStep>{step(0, 0.1), step(1, 9.0), step(2, 0.1)};
  steps[1].T_map_base_reference.reset();
  const ErrorMetrics errors = errorsOf(steps);
  EXPECT_NEAR(errors.ate_max_m, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(errors.lost_share, 0.0);
}

TEST(Metrics, CountsTimesAndParticlesAtUpdatesOnly) {
  RunRecord run;
  run.steps = {step(0, 0.0), step(1, 0.0), step(2, 0.0)};
  run.steps[0].updated = run.steps[2].updated = true;
  run.steps[0].update_ms = 2.0;
  run.steps[1].update_ms = 100.0;
  run.steps[2].update_ms = 4.0;
  run.steps[0].particles = 1000;
  run.steps[1].particles = 9999;
  run.steps[2].particles = 500;
  run.steps[0].confidence = 0.5;
  run.steps[1].confidence = run.steps[2].confidence = 1.0;
  const Metrics metrics = measure(run);
  EXPECT_EQ(metrics.scans, 3);
  EXPECT_EQ(metrics.updates, 2);
  EXPECT_DOUBLE_EQ(metrics.update_ms_median, 3.0);
  EXPECT_DOUBLE_EQ(metrics.update_ms_max, 4.0);
  EXPECT_DOUBLE_EQ(metrics.update_ms_first, 2.0);
  EXPECT_DOUBLE_EQ(metrics.update_ms_longest, 100.0) << "looked at without an update, but late";
  EXPECT_DOUBLE_EQ(metrics.particles_mean, 750.0);
  EXPECT_EQ(metrics.particles_max, 1000);
  EXPECT_NEAR(metrics.confidence_mean, 2.5 / 3.0, 1e-12);
  EXPECT_NEAR(metrics.path_m, 2.0, 1e-12) << "of the reference";
}

}  // namespace
}  // namespace adaptive_localization
