// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/swarm_race.hpp"

#include <cstdio>
#include <stdexcept>

#include "adaptive_localization/eval/report.hpp"
#include "adaptive_localization/eval/statistics.hpp"
#include "adaptive_localization/eval/swarm_fixes.hpp"
#include "adaptive_localization/swarm/swarm_search.hpp"
#include "adaptive_localization/swarm/test_functions.hpp"

namespace adaptive_localization {
namespace {

constexpr double kTolerance = 0.01;
constexpr int kMaxIterations = 500;
constexpr int kSearchers[] = {20, 50, 100, 300, 600, 1200};

SwarmRaceCell race(const TestFunction& function, const SwarmRacer& racer, int searchers, int seeds,
                   int first_seed) {
  StopRule rule;
  rule.tolerance = kTolerance;
  rule.max_iterations = kMaxIterations;
  SwarmRaceCell cell{function.name(), racer.name, searchers, {}};
  for (int seed = first_seed; seed < first_seed + seeds; ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    Swarm swarm(function.space(), spreadOver(function.space(), searchers, rng), function);
    const SearchResult result = search(swarm, *racer.move, function, rule, rng);
    cell.runs.push_back({result.iterations, result.is_reached});
  }
  return cell;
}

}  // namespace

int SwarmRaceCell::found() const {
  return static_cast<int>(sum(valuesOf(runs, &SwarmRaceRun::is_reached)));
}

double SwarmRaceCell::iterations() const {
  return mean(valuesOf(runs, &SwarmRaceRun::iterations));
}

std::vector<SwarmRacer> swarmRacers() {
  BatOptions repulsive = printedBats();
  repulsive.bat_repulsive = true;
  BatOptions no_leaps;
  no_leaps.bat_leap_share = 0.0;
  return {{"ba as printed", std::make_shared<BatMove>(repulsive)},
          {"ba, right sign", std::make_shared<BatMove>(printedBats())},
          {"ba improved", std::make_shared<BatMove>(BatOptions{})},
          {"lbba as printed", std::make_shared<BatMove>(printedBats(), printedLeaders())},
          {"lbba improved", std::make_shared<BatMove>(BatOptions{}, LeaderOptions{})},
          {"lbba improved, no leaps", std::make_shared<BatMove>(no_leaps, LeaderOptions{})},
          {"pso", std::make_shared<ParticleSwarmMove>()}};
}

std::vector<std::string> swarmNames() {
  std::vector<std::string> names;
  for (const SwarmRacer& racer : swarmRacers()) names.push_back(racer.name);
  return names;
}

std::vector<SwarmRacer> swarmRacers(const std::vector<std::string>& names) {
  std::vector<SwarmRacer> chosen;
  std::string known;
  for (const SwarmRacer& racer : swarmRacers()) known += "; " + racer.name;
  for (const std::string& name : names) {
    const auto found =
        those(swarmRacers(), [&](const SwarmRacer& racer) { return racer.name == name; });
    if (found.empty()) {
      throw std::invalid_argument("swarm: got '" + name + "', expected one of " + known.substr(2));
    }
    chosen.push_back(found.front());
  }
  return chosen;
}

std::vector<SwarmRaceCell> raceSwarms(int seeds, int first_seed) {
  std::vector<SwarmRaceCell> cells;
  const auto all = swarmRacers();
  std::vector<TestFunction> functions = testFunctions();
  for (const TestFunction& function : turnedTestFunctions()) functions.push_back(function);
  for (const TestFunction& function : functions) {
    for (const SwarmRacer& racer : all) {
      for (const int count : kSearchers)
        cells.push_back(race(function, racer, count, seeds, first_seed));
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
    std::snprintf(text, sizeof text, " %.0f (%.0f) |", cell.iterations(),
                  100.0 * cell.found() / static_cast<double>(cell.runs.size()));
    table += text;
    before = &cell;
  }
  return table + "\n";
}

void to_json(nlohmann::json& json, const SwarmRaceRun& run) {
  json = {{"iterations", run.iterations}, {"is_reached", run.is_reached}};
}

void saveJson(const std::vector<SwarmRaceCell>& cells, const std::string& file) {
  nlohmann::json json = nlohmann::json::array();
  for (const SwarmRaceCell& cell : cells) {
    json.push_back({{"function", cell.function},
                    {"move", cell.move},
                    {"searchers", cell.searchers},
                    {"runs", cell.runs}});
  }
  saveJson(json, file);
}

}  // namespace adaptive_localization
