// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/swarm_command.hpp"

#include <algorithm>
#include <stdexcept>

#include "adaptive_localization/eval/arguments.hpp"

namespace adaptive_localization {
namespace {

bool asksForHelp(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](const std::string& a) { return a == "--help" || a == "-h"; });
}

constexpr int kMostRuns = 100000, kMostSearchers = 1000000;

void refuseMore(const std::vector<std::string>& arguments, std::size_t most) {
  if (arguments.size() <= most) return;
  throw std::invalid_argument("argument '" + arguments[most] + "' is one too many");
}

/// Takes all `option VALUE` out of the arguments, and returns the values.
std::vector<std::string> takeAll(std::vector<std::string>& arguments, const std::string& option) {
  std::vector<std::string> values;
  for (auto at = std::find(arguments.begin(), arguments.end(), option); at != arguments.end();
       at = std::find(arguments.begin(), arguments.end(), option)) {
    if (at + 1 == arguments.end()) throw std::invalid_argument(option + ": its value is missing");
    values.push_back(*(at + 1));
    arguments.erase(at, at + 2);
  }
  return values;
}

int takeFirstSeed(std::vector<std::string>& arguments) {
  int seed = 1;
  for (const std::string& text : takeAll(arguments, "--first-seed")) {
    seed = toCount("--first-seed", text, 1000000000);
  }
  return seed;
}

/// What of the plan is chosen; the rest is as it was.
void takeChoices(std::vector<std::string>& arguments, SwarmFixPlan& plan) {
  const auto swarms = takeAll(arguments, "--swarm"), filters = takeAll(arguments, "--filter");
  if (!swarms.empty() || !filters.empty()) {
    plan.swarms = swarms;
    plan.filters = filters;
  }
  const auto starts = takeAll(arguments, "--start");
  if (!starts.empty()) plan.starts = starts;
  for (const std::string& text : takeAll(arguments, "--updates")) {
    plan.updates = toCount("--updates", text, kMostRuns);
  }
  for (const std::string& text : takeAll(arguments, "--noise")) {
    plan.noise = toNumber("--noise", text, {0.0, 1.0}, "0 to 1 m");
  }
  for (const std::string& text : takeAll(arguments, "--set")) {
    const auto [key, value] = toKeyAndValue("--set", text);
    plan.options.set(key, value);
  }
  const auto searchers = takeAll(arguments, "--searchers");
  if (!searchers.empty()) plan.searchers.clear();
  for (const std::string& text : searchers) {
    plan.searchers.push_back(toCount("--searchers", text, kMostSearchers));
  }
}

}  // namespace

std::string swarmFunctionsUsage() {
  return "usage: swarm_functions [SEEDS [PLOT.png]] [--first-seed N] [--json FILE]\n\n"
         "Prints how many iterations swarms of 20 to 1200 need to find the least value of\n"
         "Rastrigin, Ackley and Eggcrate to 0.01, plain and turned and shifted: the mean, a run "
         "that\n"
         "failed counting 500, and in how many runs they do.\n\n"
         "  SEEDS     runs of each swarm (default 50)\n"
         "  PLOT.png  draws the same\n"
         "  N         the first of the seeds, which follow each other (default 1)\n"
         "  --json    writes all runs\n"
         "  --help    print this\n";
}

std::string swarmFixesUsage() {
  return "usage: swarm_fixes WORLD.yaml RESOLUTION [RUNS [torus]] [OPTION VALUE]...\n\n"
         "Compares swarms, and filters, that look for the place of one scan of 11 beams.\n\n"
         "  WORLD.yaml  a floor plan, as in maps/*/world.yaml\n"
         "  RESOLUTION  of its map, m\n"
         "  RUNS        places of each kind of search (default 30)\n"
         "  torus       searchers that leave at one end of the map come back at the other\n\n"
         "  --first-seed N     the first of the seeds, which follow each other (default 1)\n"
         "  --searchers N      bats or particles; may be given several times, as all below\n"
         "  --start NAME       of swarms: free, ser or places\n"
         "  --swarm NAME       a swarm alone, as the table names it; only those that are given\n"
         "  --filter NAME      a whole core, or with another preset, as lbba/seed or mcl/fp\n"
         "  --set KEY=VALUE    an option of the whole cores\n"
         "  --updates N        of a whole core at the most, by a scan each (default 500)\n"
         "  --noise METRES     of a range, standard deviation (default 0.031); 0: exact ranges\n"
         "  --json FILE        writes all runs\n"
         "  --help             print this\n";
}

SwarmFunctionsCommand parseSwarmFunctions(std::vector<std::string> arguments) {
  SwarmFunctionsCommand command;
  command.wants_help = asksForHelp(arguments);
  if (command.wants_help) return command;
  command.first_seed = takeFirstSeed(arguments);
  for (const std::string& file : takeAll(arguments, "--json")) command.json_file = file;
  refuseMore(arguments, 2);
  if (!arguments.empty()) command.seeds = toCount("SEEDS", arguments[0], kMostRuns);
  if (arguments.size() > 1) command.plot_file = arguments[1];
  return command;
}

SwarmFixesCommand parseSwarmFixes(std::vector<std::string> arguments) {
  SwarmFixesCommand command;
  command.wants_help = asksForHelp(arguments);
  if (command.wants_help) return command;
  command.plan.first_seed = takeFirstSeed(arguments);
  takeChoices(arguments, command.plan);
  for (const std::string& file : takeAll(arguments, "--json")) command.json_file = file;
  refuseMore(arguments, 4);
  if (arguments.empty()) throw std::invalid_argument("WORLD.yaml is missing");
  if (arguments.size() < 2) throw std::invalid_argument("RESOLUTION is missing");
  SwarmFixPlan& plan = command.plan;
  plan.world = arguments[0];
  plan.resolution = toNumber("RESOLUTION", arguments[1], {0.01, 1.0}, "0.01 to 1 m");
  if (arguments.size() > 2) plan.runs = toCount("RUNS", arguments[2], kMostRuns);
  plan.is_torus = arguments.size() > 3;
  if (plan.is_torus && arguments[3] != "torus") {
    throw std::invalid_argument("the last argument: got '" + arguments[3] + "', expected torus");
  }
  return command;
}

}  // namespace adaptive_localization
