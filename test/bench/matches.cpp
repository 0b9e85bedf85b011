// SPDX-License-Identifier: BSD-3-Clause
#include "map/floor_plan.hpp"
#include "match/line_map.hpp"
#include "match/scan_matcher.hpp"
#include "measure.hpp"
#include "sim/free_space.hpp"
#include "sim/rasterize.hpp"

namespace adaptive_localization {
namespace {

constexpr int kBeams = 180;

/// A scan of half a circle with 31 mm of noise, and a guess of the pose it was taken at.
struct Shot {
  Pose2 guess;
  Scan scan;
};

FloorPlan planOf(const std::string& world) {
  return loadFloorPlan(SOURCE_DIR "/maps/" + world + "/world.yaml");
}

std::vector<Shot> shotsIn(const FloorPlan& plan) {
  const auto world = makeWorld(plan, false);
  const FreeSpace space(world, 0.2);
  Rng rng(1);
  std::vector<Shot> shots;
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector2d place = space.sample(rng);
    const Pose2 pose{place.x(), place.y(), rng.uniform(-kPi, kPi)};
    LaserScan message;
    message.angle_min = -kPi / 2;
    message.angle_increment = kPi / (kBeams - 1);
    message.range_max = 30.0;
    for (int i = 0; i < kBeams; ++i) {
      const double theta = pose.theta + message.angle_min + i * message.angle_increment;
      const double range = world->range({pose.x, pose.y, theta}, 30.0);
      message.ranges.push_back(static_cast<float>(range + rng.normal(0.0, 0.031)));
    }
    const Pose2 error{rng.normal(0.0, 0.05), rng.normal(0.0, 0.05), rng.normal(0.0, 0.03)};
    shots.push_back({pose * error, toScan(message, LaserMount{}, ScanOptions{})});
  }
  return shots;
}

/// Extraction, and association with all lines of the map.
void matchLinesOf(benchmark::State& state, const std::string& world) {
  const FloorPlan plan = planOf(world);
  const LineMap map(surfacesOf(plan));
  const auto shots = shotsIn(plan);
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.0025, 0.0025, 0.0009).asDiagonal();
  std::size_t next = 0, matched = 0;
  for (auto _ : state) {
    const Shot& shot = shots[next++ % shots.size()];
    matched += matchLines(shot.guess, covariance, linesOf(shot.scan, {}), map, {}).size();
  }
  if (matched == 0) state.SkipWithError("no line was matched");
  countItems(state, kBeams);
}

void matchScan(benchmark::State& state, const std::string& metric, const std::string& outliers) {
  const FloorPlan plan = planOf("maze");
  MatchOptions options;
  options.match_metric = metric;
  options.match_outliers = outliers;
  const ScanMatcher matcher(options, std::make_shared<const SurfaceMap>(rasterize(plan, 0.05)));
  const auto shots = shotsIn(plan);
  std::size_t next = 0, good = 0;
  for (auto _ : state) {
    const Shot& shot = shots[next++ % shots.size()];
    if (matcher.match(shot.guess, shot.scan).isGood()) ++good;
  }
  if (good == 0) state.SkipWithError("no scan was matched");
  countItems(state, kBeams);
}

}  // namespace

void registerMatches() {
  for (const std::string metric : {"line", "point"}) {
    for (const std::string outliers : {"none", "kernel", "trim", "ransac"}) {
      benchmark::RegisterBenchmark(("match/" + metric + "/" + outliers).c_str(), matchScan, metric,
                                   outliers);
    }
  }
  for (const std::string world : {"maze", "corridor"}) {
    benchmark::RegisterBenchmark(("match_lines/" + world).c_str(), matchLinesOf, world);
  }
}

}  // namespace adaptive_localization
