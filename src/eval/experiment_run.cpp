// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_run.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "core/reflectors.hpp"
#include "core/suggestion.hpp"
#include "eval/start.hpp"
#include "eval/stopwatch.hpp"
#include "experiment_drive.hpp"
#include "experiment_judge.hpp"

namespace adaptive_localization {
namespace {

/// The number of threads is the process's, so localizers are made one after the other.
std::unique_ptr<Localizer> makeLocalizer(const ExperimentSite& site, const ExperimentCore& core,
                                         int seed) {
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  Parameters parameters = core.parameters;
  parameters.set("seed", OptionValue(seed));
  parameters.set("threads", OptionValue(1));
  return std::make_unique<Localizer>(parameters, site.ground);
}

/// What is told of the start is moved along odometry, which begins there, to where the first scan
/// was taken.
Prior priorOf(const ExperimentCase& of_case, const Pose2& told, const Pose2& T_odom_base) {
  if (!of_case.is_start_known) return Anywhere{};
  return StartOptions().around(told * T_odom_base);
}

/// Of the particles from their mean, on average, m.
std::optional<double> spreadOf(const Particles& particles) {
  if (particles.size() == 0) return std::nullopt;
  const Eigen::ArrayXd dx = particles.x - particles.x.mean();
  const Eigen::ArrayXd dy = particles.y - particles.y.mean();
  return (dx.square() + dy.square()).sqrt().mean();
}

JudgedScan update(Localizer& localizer, const DriveScan& seen, const LaserMount& mount) {
  const Stopwatch watch(CLOCK_THREAD_CPUTIME_ID);  // which other runs beside it do not lengthen
  Observations observations;
  observations.stamp = seen.scan.stamp;
  observations.landmarks = seen.landmarks;
  if (!seen.scan.ranges.empty()) {
    observations.scan = toScan(seen.scan, mount, localizer.scanOptions(), seen.velocity);
    addReflectors(seen.scan, mount, localizer.scanOptions(), seen.velocity, observations);
  }
  observations.heading = seen.heading;
  observations.gyro = seen.gyro;
  observations.sonar = seen.sonar;
  JudgedScan judged;
  judged.answer = localizer.update(seen.T_odom_base, observations);
  judged.update_ms = watch.milliseconds();
  localizer.searchOn();
  judged.stamp = seen.scan.stamp;
  judged.T_odom_base = seen.T_odom_base;
  judged.T_map_base = seen.T_map_base;
  judged.particles = static_cast<int>(localizer.hypotheses().size());
  judged.spread = spreadOf(localizer.hypotheses());
  return judged;
}

Trial::Kind startOf(const ExperimentCase& of_case) {
  if (of_case.told) return Trial::Kind::kWrongStart;
  return of_case.is_start_known ? Trial::Kind::kKnownStart : Trial::Kind::kStart;
}

/// The bounds of errors on the way, where the experiment wants them. What the localizer is told of
/// the start is no knowledge where it is wrong.
std::optional<DriveBound> makeBound(const ExperimentSite& site, const ExperimentCase& of_case,
                                    const Prior& prior) {
  if (!of_case.has_bounds) return std::nullopt;
  const SimulationOptions options = SimulationOptions::from(of_case.simulation);
  return DriveBound(site.site.world, options.laser, options.odometry,
                    of_case.told ? Prior(Anywhere{}) : prior);
}

}  // namespace

void checkCore(const ExperimentSite& site, const ExperimentCase& of_case,
               const ExperimentCore& core) {
  const std::string where = of_case.experiment + ", core '" + core.label + "': ";
  try {
    const auto localizer = makeLocalizer(site, core, 1);
    const auto unknown = localizer->unknownKeys();
    if (unknown.empty()) return;
    throw std::invalid_argument("unknown option '" + unknown.front() + "'" +
                                suggestion(unknown.front(), keysOf(localizer->allOptions())));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(where + error.what());
  }
}

ExperimentResult runExperiment(const ExperimentSite& site, const ExperimentCase& of_case,
                               const ExperimentCore& core, int seed) {
  ExperimentDrive drive(site, of_case, seed);
  const auto localizer = makeLocalizer(site, core, seed);
  std::vector<LaserMount> mounts;
  for (const Pose2& mount : drive.laserMounts()) mounts.push_back(LaserMount::level(mount));
  ExperimentJudge judge(of_case);
  judge.begin(startOf(of_case), 0.0, drive.truth());
  auto seen = drive.next();
  const Prior prior = priorOf(of_case, drive.told(), seen ? seen->T_odom_base : Pose2{});
  localizer->reset(prior);
  auto bound = makeBound(site, of_case, prior);
  for (; seen; seen = drive.next()) {
    if (seen->is_lifted) judge.lift();
    if (seen->put_down) judge.begin(Trial::Kind::kKidnap, *seen->put_down, drive.truth());
    const LaserMount mount = mounts.empty() ? LaserMount{} : mounts[seen->laser];
    JudgedScan judged = update(*localizer, *seen, mount);
    if (bound && seen->put_down) bound->restart();
    if (bound && seen->T_map_base) judged.bounds = bound->scan(*seen->T_map_base);
    judge.observe(judged);
    drive.localize(judged.answer.T_map_odom);
  }
  ExperimentResult result = judge.finish();
  result.arrival_errors_m = drive.mission().arrivalErrors();
  result.way_error_m = drive.mission().wayError();
  result.filter = localizer->options().filter;
  result.preset = localizer->options().preset;
  return result;
}

}  // namespace adaptive_localization
