// SPDX-License-Identifier: BSD-3-Clause
// How many iterations swarms need to find the least value of a function.
#include "bench/swarm_racers.hpp"
#include "bench/test_functions.hpp"
#include "eval/arguments.hpp"
#include "eval/program.hpp"
#include "eval/report.hpp"
#include "swarm/swarm_search.hpp"

namespace adaptive_localization {
namespace {

using Json = nlohmann::json;

constexpr char kUsage[] =
    "usage: swarm_functions --json FILE [--seeds N] [--first-seed N]\n\n"
    "Writes how many iterations swarms of 20 to 1200 need to find the least value of Rastrigin,\n"
    "Ackley and Eggcrate to 0.01, plain and turned and shifted; 500 at the most. scripts/swarms\n"
    "makes a table and a plot of them.\n\n"
    "  --seeds N       runs of each swarm (default 50)\n"
    "  --first-seed N  the first of the seeds, which follow each other (default 1)\n"
    "  --help          print this\n";
constexpr int kSearchers[] = {20, 50, 100, 300, 600, 1200};

struct Command {
  int seeds{50}, first_seed{1};
  std::string json_file;
  bool wants_help{false};
};

Command parse(const std::vector<std::string>& arguments) {
  Command command;
  ArgumentParser parser;
  parser.text("--json", command.json_file);
  parser.option("--seeds", [&](const auto& v) { command.seeds = toCount("--seeds", v, 100000); });
  parser.option("--first-seed", [&](const auto& v) {
    command.first_seed = toCount("--first-seed", v, 1000000000);
  });
  command.wants_help = !parser.parse(arguments);
  if (!command.wants_help && command.json_file.empty()) {
    throw std::invalid_argument("--json is missing");
  }
  return command;
}

Json race(const TestFunction& function, const SwarmRacer& racer, int searchers,
          const Command& command) {
  StopRule rule;
  rule.tolerance = 0.01;
  rule.max_iterations = 500;
  Json runs = Json::array();
  for (int seed = command.first_seed; seed < command.first_seed + command.seeds; ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    Swarm swarm(function.space(), spreadOver(function.space(), searchers, rng), function);
    const SearchResult result = search(swarm, *racer.move, function, rule, rng);
    runs.push_back({{"iterations", result.iterations}, {"is_reached", result.is_reached}});
  }
  return {{"function", function.name()},
          {"move", racer.name},
          {"searchers", searchers},
          {"runs", runs}};
}

void run(const Command& command) {
  Json cells = Json::array();
  for (const auto& functions : {testFunctions(), turnedTestFunctions()}) {
    for (const TestFunction& function : functions) {
      for (const SwarmRacer& racer : swarmRacers()) {
        for (const int count : kSearchers) {
          cells.push_back(race(function, racer, count, command));
        }
      }
    }
  }
  saveJson(cells, command.json_file);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("swarm_functions", al::kUsage, al::parse, al::run, {argv + 1, argv + argc});
}
