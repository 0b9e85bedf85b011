// SPDX-License-Identifier: BSD-3-Clause
#include "bench/swarm_fixes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "adaptive_localization/filters/builtins.hpp"
#include "bench/swarm_fix_scene.hpp"
#include "eval/report.hpp"
#include "eval/stopwatch.hpp"
#include "swarm/swarm_search.hpp"

namespace adaptive_localization {
namespace {

constexpr double kTolerance = 0.03;
constexpr int kMaxIterations = 500;
constexpr double kRight = 0.15, kRightTurn = 5.0 * kPi / 180.0;  // m, rad

/// Where the laser stands in a run, and what it sees: the same for all.
struct Sight {
  Sight(const SwarmFixScene& scene, int seed)
      : rng(static_cast<std::uint64_t>(seed)),
        truth(scene.place(rng)),
        observations(scene.observe(truth, rng)) {}

  Rng rng;
  Pose2 truth;
  Observations observations;
};

/// How far the answer is off, and the answer once it is matched.
SwarmFixRun judged(SwarmFixRun run, const Pose2& answer, const SwarmFixScene& scene,
                   const Sight& sight) {
  const Scan& scan = sight.observations.scan;
  run.error_mm = 1000.0 * distance(answer, sight.truth);
  run.matched_mm = 1000.0 * distance(scene.matched(answer, scan), sight.truth);
  run.is_found = run.error_mm < 1000.0 * kRight &&
                 std::abs(wrapAngle(answer.theta - sight.truth.theta)) < kRightTurn;
  return run;
}

SwarmFixRun searchWith(const SwarmMove& move, const SwarmFixScene& scene, Sight& sight,
                       const SwarmFixPlan& plan, const SwarmFixCell& cell) {
  const auto start = scene.spread(cell.start, cell.searchers, sight.observations, sight.rng);
  StopRule rule;
  rule.tolerance = kTolerance;
  rule.max_iterations = kMaxIterations;
  const Stopwatch watch;
  const TableObjective objective = scene.objective(sight.observations.scan);
  Swarm swarm(scene.space(plan.is_torus), start, objective);
  const SearchResult result = search(swarm, move, objective, rule, sight.rng);
  SwarmFixRun run;
  run.iterations = result.iterations;
  run.cost = swarm.best_cost;
  run.is_reached = result.is_reached;
  run.ms = watch.milliseconds();
  return judged(run, {swarm.best[0], swarm.best[1], swarm.best[2]}, scene, sight);
}

SwarmFixRun localizeWith(Filter& filter, const SwarmFixScene& scene, Sight& sight, int updates) {
  SwarmFixRun run;
  Pose2 answer;
  const Stopwatch watch;
  filter.reset(Anywhere{});
  while (!run.is_reached && run.iterations < updates) {
    answer = filter.update({}, sight.observations).T_map_base;
    ++run.iterations;
    Eigen::ArrayXXd position(1, 3);
    position << answer.x, answer.y, answer.theta;
    Eigen::ArrayXd cost(1);
    scene.objective(sight.observations.scan).evaluate(position, cost);
    run.cost = cost[0];
    run.is_reached = run.cost <= kTolerance;
    sight.observations = scene.observe(sight.truth, sight.rng);
  }
  run.ms = watch.milliseconds();
  return judged(run, answer, scene, sight);
}

std::unique_ptr<Filter> makeFilter(const std::string& name, int count, int seed,
                                   const SwarmFixScene& scene, const SwarmFixPlan& plan) {
  const auto context =
      scene.contextFor(name, count, static_cast<std::uint64_t>(seed), plan.options);
  auto filter = builtins().filters.make(name.substr(0, name.find('/')), context);
  for (const std::string& key : context.parameters.unknownKeys()) {
    if (!plan.options.has(key)) continue;
    throw std::invalid_argument("option '" + key + "' is unknown to filter '" + name + "'");
  }
  return filter;
}

/// Runs with one seed after the other.
template <class Find>
SwarmFixCell runAll(SwarmFixCell cell, const SwarmFixPlan& plan, const SwarmFixScene& scene,
                    const Find& find) {
  for (int seed = plan.first_seed; seed < plan.first_seed + plan.runs; ++seed) {
    Sight sight(scene, seed);
    cell.runs.push_back(find(sight, seed));
    cell.runs.back().seed = seed;
  }
  return cell;
}

}  // namespace

int SwarmFixCell::found() const {
  return static_cast<int>(foundRuns().size());
}

std::vector<SwarmFixRun> SwarmFixCell::foundRuns() const {
  std::vector<SwarmFixRun> found;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(found),
               [](const SwarmFixRun& run) { return run.is_found; });
  return found;
}

double SwarmFixCell::meanIterations() const {
  double sum = 0.0;
  for (const SwarmFixRun& run : runs) sum += run.iterations;
  return runs.empty() ? 0.0 : sum / static_cast<double>(runs.size());
}

std::vector<SwarmFixCell> raceFixes(const SwarmFixPlan& plan) {
  const SwarmFixScene scene(plan.world, plan.resolution, plan.noise);
  std::vector<SwarmFixCell> cells;
  const std::vector<SwarmRacer> racers = swarmRacers(plan.swarms);
  for (const std::string& start : plan.starts) {
    for (const SwarmRacer& racer : racers) {
      for (const int count : plan.searchers) {
        const SwarmFixCell cell{start, racer.name, count};
        cells.push_back(runAll(cell, plan, scene, [&](Sight& sight, int) {
          return searchWith(*racer.move, scene, sight, plan, cell);
        }));
      }
    }
  }
  for (const std::string& filter : plan.filters) {
    for (const int count : plan.searchers) {
      cells.push_back(runAll({"its own", filter, count}, plan, scene, [&](Sight& sight, int seed) {
        return localizeWith(*makeFilter(filter, count, seed, scene, plan), scene, sight,
                            plan.updates);
      }));
    }
  }
  return cells;
}

void to_json(nlohmann::json& json, const SwarmFixRun& run) {
  json = {{"seed", run.seed},
          {"iterations", run.iterations},
          {"cost", run.cost},
          {"is_reached", run.is_reached},
          {"is_found", run.is_found},
          {"error_mm", run.error_mm},
          {"matched_mm", run.matched_mm},
          {"ms", run.ms}};
}

void saveJson(const std::vector<SwarmFixCell>& cells, const std::string& file) {
  nlohmann::json json = nlohmann::json::array();
  for (const SwarmFixCell& cell : cells) {
    json.push_back({{"start", cell.start},
                    {"core", cell.core},
                    {"searchers", cell.searchers},
                    {"runs", cell.runs}});
  }
  saveJson(json, file);
}

}  // namespace adaptive_localization
