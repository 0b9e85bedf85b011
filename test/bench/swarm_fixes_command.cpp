// SPDX-License-Identifier: BSD-3-Clause
// Compares swarms, and filters, that look for the place of one scan.
#include "bench/swarm_fixes.hpp"
#include "eval/arguments.hpp"
#include "eval/program.hpp"

namespace adaptive_localization {
namespace {

constexpr char kUsage[] =
    "usage: swarm_fixes --world WORLD.yaml --json FILE [options]\n\n"
    "Compares swarms, and filters, that look for the place of one scan of 11 beams, and writes "
    "all\n"
    "runs. scripts/swarms makes a table of them.\n\n"
    "  --world WORLD.yaml  a floor plan, as in maps/*/world.yaml\n"
    "  --resolution M      of its map (default 0.05)\n"
    "  --runs N            places of each kind of search (default 30)\n"
    "  --torus             searchers that leave at one end of the map come back at the other\n"
    "  --first-seed N      the first of the seeds, which follow each other (default 1)\n"
    "  --searchers N       bats or particles; may be given several times, as all below\n"
    "  --start NAME        of swarms: free, ser or places\n"
    "  --swarm NAME        a swarm alone; only those that are given\n"
    "  --filter NAME       a whole core, or with another preset, as lbba/seed or mcl/fp\n"
    "  --set KEY=VALUE     an option of the whole cores\n"
    "  --updates N         of a whole core at the most, by a scan each (default 500)\n"
    "  --noise METRES      of a range, standard deviation (default 0.031); 0: exact ranges\n"
    "  --help              print this\n";
constexpr int kMostRuns = 100000, kMostSearchers = 1000000, kMostSeeds = 1000000000;

struct Command {
  SwarmFixPlan plan;
  std::string json_file;
  bool wants_help{false};
};

Command parse(const std::vector<std::string>& arguments) {
  Command command;
  SwarmFixPlan& plan = command.plan;
  std::vector<int> searchers;
  std::vector<std::string> starts, swarms, filters;
  ArgumentParser parser;
  parser.text("--world", plan.world);
  parser.text("--json", command.json_file);
  parser.flag("--torus", plan.is_torus);
  const auto count = [&](const std::string& name, int most, const std::function<void(int)>& take) {
    parser.option(name, [=](const std::string& text) { take(toCount(name, text, most)); });
  };
  const auto number = [&](const std::string& name, double& target, const Range& range,
                          const std::string& expected) {
    parser.option(name, [=, &target](const std::string& text) {
      target = toNumber(name, text, range, expected);
    });
  };
  count("--runs", kMostRuns, [&](int value) { plan.runs = value; });
  count("--updates", kMostRuns, [&](int value) { plan.updates = value; });
  count("--first-seed", kMostSeeds, [&](int value) { plan.first_seed = value; });
  count("--searchers", kMostSearchers, [&](int value) { searchers.push_back(value); });
  number("--resolution", plan.resolution, {0.01, 1.0}, "0.01 to 1 m");
  number("--noise", plan.noise, {0.0, 1.0}, "0 to 1 m");
  parser.option("--start", [&](const auto& v) { starts.push_back(v); });
  parser.option("--swarm", [&](const auto& v) { swarms.push_back(v); });
  parser.option("--filter", [&](const auto& v) { filters.push_back(v); });
  parser.option("--set", [&](const auto& v) {
    const auto [key, value] = toKeyAndValue("--set", v);
    plan.options.set(key, value);
  });
  command.wants_help = !parser.parse(arguments);
  if (command.wants_help) return command;
  if (plan.world.empty()) throw std::invalid_argument("--world is missing");
  if (command.json_file.empty()) throw std::invalid_argument("--json is missing");
  if (!searchers.empty()) plan.searchers = searchers;
  if (!starts.empty()) plan.starts = starts;
  if (!swarms.empty() || !filters.empty()) {
    plan.swarms = swarms;
    plan.filters = filters;
  }
  return command;
}

void run(const Command& command) {
  saveJson(raceFixes(command.plan), command.json_file);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("swarm_fixes", al::kUsage, al::parse, al::run, {argv + 1, argv + argc});
}
