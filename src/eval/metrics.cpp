// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics.hpp"

#include <algorithm>
#include <cmath>

#include "eval/consistency.hpp"
#include "eval/statistics.hpp"

namespace adaptive_localization {
namespace {

constexpr double kDegrees = 180.0 / kPi;

void addConsistency(const std::vector<RunStep>& steps, ErrorMetrics& errors) {
  std::vector<double> normalized;
  for (const auto& step : steps) {
    if (!step.T_map_base_reference || !step.updated) continue;
    const auto error =
        normalizedError(step.T_map_base, step.covariance, *step.T_map_base_reference);
    if (error) normalized.push_back(*error);
  }
  if (normalized.empty()) return;
  const Band band = consistencyBand(1);
  const auto inside = std::count_if(normalized.begin(), normalized.end(),
                                    [&](double error) { return band.contains(error); });
  errors.nees_mean = mean(normalized);
  errors.nees_median = quantile(normalized, 0.5);
  errors.nees_in_band = static_cast<double>(inside) / static_cast<double>(normalized.size());
}

double headingError(const RunStep& step) {
  return std::abs(wrapAngle(step.T_map_base.theta - step.T_map_base_reference->theta));
}

bool isFound(const RunStep& step) {
  return isNear(step.T_map_base, *step.T_map_base_reference);
}

std::optional<ErrorMetrics> measureErrors(const std::vector<RunStep>& steps) {
  std::vector<double> positions, headings;
  std::optional<double> found_at, tracking_at;
  Calibration calibration;
  int lost = 0;
  int misled = 0;
  for (const auto& step : steps) {
    if (!step.T_map_base_reference) continue;
    positions.push_back(distance(step.T_map_base, *step.T_map_base_reference));
    headings.push_back(headingError(step));
    calibration.note(step.confidence, positions.back());
    const bool is_tracking = step.status == Status::kTracking;
    if (is_tracking && !tracking_at) tracking_at = step.stamp - steps.front().stamp;
    if (!isFound(step)) {
      ++lost;
      misled += is_tracking ? 1 : 0;
      found_at.reset();
    } else if (!found_at) {
      found_at = step.stamp - steps.front().stamp;
    }
  }
  if (positions.empty()) return {};
  ErrorMetrics errors;
  errors.ate_rmse_m = rootMeanSquare(positions);
  errors.ate_mean_m = mean(positions);
  errors.ate_median_m = quantile(positions, 0.5);
  errors.ate_p95_m = quantile(positions, 0.95);
  errors.ate_max_m = largest(positions);
  errors.heading_rmse_deg = kDegrees * rootMeanSquare(headings);
  errors.final_error_m = positions.back();
  errors.final_heading_error_deg = kDegrees * headings.back();
  errors.converged_at_s = found_at;
  errors.lost_share = static_cast<double>(lost) / static_cast<double>(positions.size());
  errors.misled_share = static_cast<double>(misled) / static_cast<double>(positions.size());
  errors.tracking_at_s = tracking_at;
  errors.calibration = calibration;
  errors.carryings = carryingsOf(steps);
  addConsistency(steps, errors);
  return errors;
}

/// Counted from the answer before, as what came between is not known.
double longestMisled(const std::vector<RunStep>& steps) {
  double longest = 0.0;
  std::optional<double> since;
  double before = steps.empty() ? 0.0 : steps.front().stamp;
  for (const auto& step : steps) {
    if (!step.T_map_base_reference) continue;
    if (step.status != Status::kTracking || isFound(step)) {
      since.reset();
    } else {
      if (!since) since = before;
      longest = std::max(longest, step.stamp - *since);
    }
    before = step.stamp;
  }
  return longest;
}

int countJumps(const std::vector<RunStep>& steps) {
  int jumps = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const RunStep& before = steps[i - 1];
    const Pose2 expected = before.T_map_base * between(before.T_odom_base, steps[i].T_odom_base);
    const bool was_somewhere = before.status != Status::kUninitialised;
    jumps += was_somewhere && distance(expected, steps[i].T_map_base) > kLostDistance;
  }
  return jumps;
}

double pathLength(const std::vector<RunStep>& steps) {
  std::vector<Pose2> reference, odometry;
  for (const auto& step : steps) {
    odometry.push_back(step.T_odom_base);
    if (step.T_map_base_reference) reference.push_back(*step.T_map_base_reference);
  }
  const auto& poses = reference.empty() ? odometry : reference;
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) length += distance(poses[i - 1], poses[i]);
  return length;
}

}  // namespace

Metrics measure(const RunRecord& run) {
  std::vector<double> times, cpu_times, particles, confidences;
  int tracking = 0, nowhere = 0;
  Metrics metrics;
  for (const auto& step : run.steps) {
    const bool is_first = &step == &run.steps.front();
    double& longest = is_first ? metrics.update_ms_first : metrics.update_ms_longest;
    longest = std::max(longest, step.update_ms);
    confidences.push_back(step.confidence);
    metrics.status[toText(step.status)] += 1.0 / static_cast<double>(run.steps.size());
    if (!step.updated) continue;
    times.push_back(step.update_ms);
    cpu_times.push_back(step.cpu_ms);
    particles.push_back(step.particles);
    tracking += step.status == Status::kTracking ? 1 : 0;
    nowhere += step.status == Status::kLost || step.status == Status::kGlobalizing ? 1 : 0;
  }
  metrics.scans = static_cast<int>(run.steps.size());
  metrics.updates = static_cast<int>(times.size());
  if (!run.steps.empty()) metrics.duration_s = run.steps.back().stamp - run.steps.front().stamp;
  metrics.path_m = pathLength(run.steps);
  metrics.wall_s = run.wall_s;
  metrics.cpu_s = run.cpu_s;
  metrics.peak_rss_mb = run.peak_rss_mb;
  metrics.update_ms_median = quantile(times, 0.5);
  metrics.update_ms_p99 = quantile(times, 0.99);
  metrics.update_ms_max = largest(times);
  metrics.update_cpu_ms_median = quantile(cpu_times, 0.5);
  metrics.update_cpu_ms_mean = mean(cpu_times);
  metrics.particles_mean = mean(particles);
  metrics.particles_max = static_cast<int>(largest(particles));
  metrics.confidence_mean = mean(confidences);
  if (metrics.updates > 0) {
    metrics.tracking_share = static_cast<double>(tracking) / metrics.updates;
    metrics.nowhere_share = static_cast<double>(nowhere) / metrics.updates;
  }
  metrics.jumps = countJumps(run.steps);
  metrics.errors = measureErrors(run.steps);
  if (metrics.errors) metrics.errors->misled_longest_s = longestMisled(run.steps);
  return metrics;
}

bool isMisfit(const Metrics& metrics) {
  constexpr double kHardlyEver = 0.05;
  constexpr double kOften = 0.2;
  return metrics.tracking_share < kHardlyEver && metrics.nowhere_share > kOften;
}

}  // namespace adaptive_localization
