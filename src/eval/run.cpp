// SPDX-License-Identifier: BSD-3-Clause
#include "eval/run.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/reflectors.hpp"
#include "eval/stopwatch.hpp"

namespace adaptive_localization {
namespace {

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::optional<BaseVelocity> velocityBetween(const LogScan& before, const LogScan& after) {
  constexpr double kLongest = 0.5;  // s
  const double seconds = after.scan.stamp - before.scan.stamp;
  if (!(seconds > 1e-3 && seconds < kLongest)) return std::nullopt;
  const Pose2 motion = between(before.T_odom_base, after.T_odom_base);
  return BaseVelocity{motion.x / seconds, motion.y / seconds, motion.theta / seconds};
}

/// Columns for the hits of a scan taken at a pose.
Eigen::Array3Xd hitsOf(const Scan& scan, const Pose2& T_map_base, const DistanceField& field) {
  Eigen::Array3Xd hits(3, scan.x.size());
  for (Eigen::Index i = 0; i < scan.x.size(); ++i) {
    const Eigen::Vector2d hit = T_map_base * Eigen::Vector2d(scan.x[i], scan.y[i]);
    hits.col(i) << hit.x(), hit.y(), field.at(hit);
  }
  return hits;
}

Eigen::Array3Xd someOf(const Particles& particles) {
  constexpr Eigen::Index kMost = 200;
  const Eigen::Index count = std::min(particles.size(), kMost);
  Eigen::Array3Xd some(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Pose2 pose = particles.pose(i * particles.size() / count);
    some.col(i) << pose.x, pose.y, pose.theta;
  }
  return some;
}

/// Adds a step, and a view if there are to be more.
void addStep(const LogScan& log_scan, const BaseVelocity& velocity, Localizer& localizer,
             std::size_t views, RunRecord& run) {
  const Stopwatch watch;
  const Stopwatch cpu_watch(CLOCK_PROCESS_CPUTIME_ID);
  Observations observations;
  observations.stamp = log_scan.scan.stamp;
  observations.scan = toScan(log_scan.scan, log_scan.mount, localizer.scanOptions(), velocity);
  observations.heading = log_scan.heading;
  observations.gyro = log_scan.gyro;
  observations.landmarks = log_scan.landmarks;
  addReflectors(log_scan.scan, log_scan.mount, localizer.scanOptions(), velocity, observations);
  observations.sonar = log_scan.sonar;
  const Localization answer = localizer.update(log_scan.T_odom_base, observations);
  RunStep result;
  result.update_ms = watch.milliseconds();
  localizer.searchOn();
  result.cpu_ms = cpu_watch.milliseconds();
  result.stamp = log_scan.scan.stamp;
  result.T_odom_base = log_scan.T_odom_base;
  result.T_map_base = answer.T_map_base;
  result.covariance = answer.covariance;
  result.T_map_base_reference = log_scan.T_map_base;
  result.confidence = answer.confidence;
  result.status = answer.status;
  result.updated = answer.updated;
  result.particles = static_cast<int>(localizer.hypotheses().size());
  result.fit = localizer.confidence().latestFit();
  result.modes = static_cast<int>(answer.modes.size());
  run.steps.push_back(result);
  if (run.views.size() >= views) return;
  run.views.push_back({result.stamp, answer.modes,
                       hitsOf(observations.scan, answer.T_map_base, localizer.field()),
                       someOf(localizer.hypotheses())});
}

}  // namespace

BaseVelocity velocityAt(const Log& log, std::size_t i) {
  std::optional<BaseVelocity> velocity;
  if (i + 1 < log.scans.size()) velocity = velocityBetween(log.scans[i], log.scans[i + 1]);
  if (!velocity && i > 0) velocity = velocityBetween(log.scans[i - 1], log.scans[i]);
  return velocity.value_or(BaseVelocity{});
}

RunRecord runLog(const Log& log, Localizer& localizer, const RunProgress& progress,
                 std::size_t views) {
  RunRecord run;
  run.steps.reserve(log.scans.size());
  const Stopwatch watch;
  const Stopwatch cpu_watch(CLOCK_PROCESS_CPUTIME_ID);
  std::string first_problem;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    try {
      const std::size_t views_by_now = (i * views + views) / log.scans.size();  // evenly spread
      addStep(log.scans[i], velocityAt(log, i), localizer, views_by_now, run);
    } catch (const std::invalid_argument& error) {
      if (run.skipped++ == 0) first_problem = error.what();
    }
    if (progress) progress(i + 1);
  }
  if (run.steps.empty()) throw std::invalid_argument("no usable scan: " + first_problem);
  if (run.skipped > 0) {
    run.warnings.push_back("scans that cannot be used, skipped: " + std::to_string(run.skipped) +
                           "; the first: " + first_problem);
  }
  run.wall_s = watch.seconds();
  run.cpu_s = cpu_watch.seconds();
  run.peak_rss_mb = peakMegabytes();
  return run;
}

}  // namespace adaptive_localization
