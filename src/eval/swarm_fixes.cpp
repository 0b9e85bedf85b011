// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/swarm_fixes.hpp"

#include <cmath>
#include <cstdio>

#include "adaptive_localization/eval/statistics.hpp"
#include "adaptive_localization/eval/stopwatch.hpp"
#include "adaptive_localization/filters/builtins.hpp"
#include "adaptive_localization/swarm/swarm_search.hpp"
#include "swarm_fix_scene.hpp"

namespace adaptive_localization {
namespace {

constexpr double kTolerance = 0.03;
constexpr int kMaxIterations = 500;
constexpr double kRight = 0.15, kRightTurn = 5.0 * kPi / 180.0;  // m, rad

/// What came of one search.
struct Outcome {
  Pose2 found;
  int iterations{0};
  bool is_reached{false};
  double ms{0.0};
};

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

Outcome searchWith(const SwarmMove& move, const SwarmFixScene& scene, Sight& sight,
                   const SwarmFixPlan& plan, const SwarmFixCell& cell) {
  const auto start = scene.spread(cell.start, cell.searchers, sight.observations, sight.rng);
  StopRule rule;
  rule.tolerance = kTolerance;
  rule.max_iterations = kMaxIterations;
  const Stopwatch watch;
  const TableObjective objective = scene.objective(sight.observations.scan);
  Swarm swarm(scene.space(plan.is_torus), start, objective);
  const SearchResult result = search(swarm, move, objective, rule, sight.rng);
  return {{swarm.best[0], swarm.best[1], swarm.best[2]},
          result.iterations,
          result.is_reached,
          watch.milliseconds()};
}

Outcome localizeWith(Filter& filter, const SwarmFixScene& scene, Sight& sight) {
  Outcome outcome;
  const Stopwatch watch;
  filter.reset(Anywhere{});
  while (!outcome.is_reached && outcome.iterations < kMaxIterations) {
    outcome.found = filter.update({}, sight.observations).T_map_base;
    ++outcome.iterations;
    Eigen::ArrayXXd position(1, 3);
    position << outcome.found.x, outcome.found.y, outcome.found.theta;
    Eigen::ArrayXd cost(1);
    scene.objective(sight.observations.scan).evaluate(position, cost);
    outcome.is_reached = cost[0] <= kTolerance;
    sight.observations = scene.observe(sight.truth, sight.rng);
  }
  outcome.ms = watch.milliseconds();
  return outcome;
}

/// Runs with one seed after the other.
template <class Find>
SwarmFixCell runAll(SwarmFixCell cell, int first_seed, const SwarmFixScene& scene,
                    const Find& find) {
  std::vector<double> times, errors, matched;
  for (int seed = first_seed; seed < first_seed + cell.runs; ++seed) {
    Sight sight(scene, seed);
    const Outcome outcome = find(sight, seed);
    const double error = distance(outcome.found, sight.truth);
    cell.iterations.push_back(outcome.iterations);
    cell.reached += outcome.is_reached ? 1 : 0;
    times.push_back(outcome.ms);
    if (error < kRight &&
        std::abs(wrapAngle(outcome.found.theta - sight.truth.theta)) < kRightTurn) {
      ++cell.found;
      errors.push_back(1000.0 * error);
      matched.push_back(
          1000.0 * distance(scene.matched(outcome.found, sight.observations.scan), sight.truth));
    }
  }
  cell.error_mm = mean(errors);
  cell.matched_mm = mean(matched);
  cell.matched_std_mm = deviation(matched);
  if (!matched.empty()) {
    cell.matched_ic99_mm = 2.58 * cell.matched_std_mm / std::sqrt(matched.size());
  }
  cell.ms_median = quantile(times, 0.5);
  cell.ms_mean = mean(times);
  return cell;
}

/// Nothing where nobody was found.
std::string errorsOf(const SwarmFixCell& cell) {
  if (cell.found == 0) return "| |";
  char text[100];
  std::snprintf(text, sizeof text, "| %.1f | %.1f / %.1f / %.1f", cell.error_mm, cell.matched_mm,
                cell.matched_ic99_mm, cell.matched_std_mm);
  return text;
}

std::string rowOf(const SwarmFixCell& cell) {
  char row[300];
  std::snprintf(row, sizeof row, "| %s | %s | %d | %.0f | %.0f | %.1f %s | %.2f | %.2f |\n",
                cell.start.c_str(), cell.core.c_str(), cell.searchers,
                100.0 * cell.found / cell.runs, 100.0 * cell.reached / cell.runs,
                cell.meanIterations(), errorsOf(cell).c_str(), cell.ms_median, cell.ms_mean);
  return row;
}

/// The improved leaders against the bats with the right sign, as far as both are there.
std::string comparison(const std::vector<SwarmFixCell>& cells) {
  std::string text;
  for (const SwarmFixCell& leaders : cells) {
    for (const SwarmFixCell& bats : cells) {
      if (leaders.core != "lbba improved" || bats.core != "ba, right sign") continue;
      if (leaders.start != bats.start || leaders.searchers != bats.searchers) continue;
      char row[200];
      std::snprintf(row, sizeof row, "| %s | %d | %.1f | %.1f | %.2g | %.2g |\n",
                    leaders.start.c_str(), leaders.searchers, leaders.meanIterations(),
                    bats.meanIterations(),
                    signedRankTestOfLess(leaders.iterations, bats.iterations),
                    signTestOfLess(leaders.iterations, bats.iterations));
      text += row;
    }
  }
  if (text.empty()) return text;
  return "\n| start | searchers | iterations of lbba improved | of ba, right sign | p, signed "
         "ranks "
         "| p, signs |\n|---|---|---|---|---|---|\n" +
         text;
}

}  // namespace

double SwarmFixCell::meanIterations() const {
  return mean({iterations.begin(), iterations.end()});
}

std::vector<SwarmFixCell> raceFixes(const SwarmFixPlan& plan) {
  const SwarmFixScene scene(plan.world, plan.resolution);
  std::vector<SwarmFixCell> cells;
  for (const std::string& start : plan.starts) {
    for (const SwarmRacer& racer : swarmRacers()) {
      for (const int count : plan.searchers) {
        const SwarmFixCell cell{start, racer.name, count, plan.runs};
        cells.push_back(runAll(cell, plan.first_seed, scene, [&](Sight& sight, int) {
          return searchWith(*racer.move, scene, sight, plan, cell);
        }));
      }
    }
  }
  for (const std::string& filter : plan.filters) {
    for (const int count : plan.searchers) {
      cells.push_back(runAll(
          {"its own", filter, count, plan.runs}, plan.first_seed, scene,
          [&](Sight& sight, int seed) {
            const auto context = scene.contextFor(filter, count, static_cast<std::uint64_t>(seed));
            return localizeWith(*builtins().filters.make(filter, context), scene, sight);
          }));
    }
  }
  return cells;
}

std::string toTable(const std::vector<SwarmFixCell>& cells) {
  std::string table =
      "| start | core | searchers | found, % | reached 3 %, % | iterations | error of those found, "
      "mm "
      "| the same matched, mm: mean / IC99 / sigma | ms per fix: median | mean |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const SwarmFixCell& cell : cells) table += rowOf(cell);
  return table + comparison(cells);
}

}  // namespace adaptive_localization
