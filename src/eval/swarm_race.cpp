// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/swarm_race.hpp"

#include <cstdio>
#include <memory>

#include "adaptive_localization/swarm/swarm_move.hpp"
#include "adaptive_localization/swarm/test_functions.hpp"

namespace adaptive_localization {
namespace {

constexpr double kTolerance = 0.01;
constexpr int kMaxIterations = 500;
constexpr int kSearchers[] = {20, 50, 100, 300, 600, 1200};

struct Racer {
  std::string name;
  std::unique_ptr<const SwarmMove> move;
};

std::vector<Racer> racers() {
  BatOptions repulsive = printedBats();
  repulsive.bat_repulsive = true;
  std::vector<Racer> all;
  all.push_back({"ba as printed", std::make_unique<BatMove>(repulsive)});
  all.push_back({"ba, right sign", std::make_unique<BatMove>(printedBats())});
  all.push_back({"lbba as printed", std::make_unique<BatMove>(printedBats(), printedLeaders())});
  all.push_back({"lbba improved", std::make_unique<BatMove>(BatOptions{}, LeaderOptions{})});
  all.push_back({"pso", std::make_unique<ParticleSwarmMove>()});
  return all;
}

SwarmRaceCell race(const TestFunction& function, const Racer& racer, int searchers, int seeds) {
  StopRule rule;
  rule.tolerance = kTolerance;
  rule.max_iterations = kMaxIterations;
  SwarmRaceCell cell{function.name(), racer.name, searchers, seeds};
  for (int seed = 1; seed <= seeds; ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    Swarm swarm(function.space(), spreadOver(function.space(), searchers, rng), function);
    const SearchResult result = search(swarm, *racer.move, function, rule, rng);
    cell.iterations += result.iterations / static_cast<double>(seeds);
    cell.found += result.is_reached ? 1 : 0;
  }
  return cell;
}

}  // namespace

std::vector<SwarmRaceCell> raceSwarms(int seeds) {
  std::vector<SwarmRaceCell> cells;
  const auto all = racers();
  for (const TestFunction& function : testFunctions()) {
    for (const Racer& racer : all) {
      for (const int count : kSearchers) cells.push_back(race(function, racer, count, seeds));
    }
  }
  return cells;
}

std::string toTable(const std::vector<SwarmRaceCell>& cells) {
  std::string table = "| iterations (found, %) |";
  std::string line = "|---|";
  for (const int count : kSearchers) {
    table += " " + std::to_string(count) + " |";
    line += "---|";
  }
  table += "\n" + line;
  const SwarmRaceCell* before = nullptr;
  for (const SwarmRaceCell& cell : cells) {
    if (!before || before->function != cell.function || before->move != cell.move) {
      table += "\n| " + cell.function + ", " + cell.move + " |";
    }
    char text[64];
    std::snprintf(text, sizeof text, " %.0f (%.0f) |", cell.iterations,
                  100.0 * cell.found / cell.runs);
    table += text;
    before = &cell;
  }
  return table + "\n";
}

}  // namespace adaptive_localization
