// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/swarm_command.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <stdexcept>

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

std::string refusal(const std::function<void()>& parse) {
  try {
    parse();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing is wrong";
}

std::string refusedFixes(const Arguments& arguments) {
  return refusal([&] { parseSwarmFixes(arguments); });
}

std::string refusedFunctions(const Arguments& arguments) {
  return refusal([&] { parseSwarmFunctions(arguments); });
}

TEST(SwarmCommand, ReadsWhatWasAskedFor) {
  EXPECT_EQ(parseSwarmFunctions({}).seeds, 50);
  EXPECT_EQ(parseSwarmFunctions({"7", "race.png"}).seeds, 7);
  EXPECT_EQ(parseSwarmFunctions({"7", "race.png"}).plot_file, "race.png");
  const SwarmFixPlan plan = parseSwarmFixes({"world.yaml", "0.1", "40", "torus"}).plan;
  EXPECT_EQ(plan.world, "world.yaml");
  EXPECT_EQ(plan.resolution, 0.1);
  EXPECT_EQ(plan.runs, 40);
  EXPECT_TRUE(plan.is_torus);
  EXPECT_EQ(parseSwarmFixes({"world.yaml", "0.05"}).plan.runs, 30);
  EXPECT_FALSE(parseSwarmFixes({"world.yaml", "0.05", "3"}).plan.is_torus);
}

TEST(SwarmCommand, ReadsOptionsOfTheCores) {
  const SwarmFixPlan plan = parseSwarmFixes({"w.yaml", "0.1", "--set", "swarm_beams=9"}).plan;
  EXPECT_TRUE(plan.options.has("swarm_beams"));
  for (const std::string text : {"swarm_beams", "=9", ""}) {
    EXPECT_THAT(refusedFixes({"w.yaml", "0.1", "--set", text}),
                HasSubstr("--set: got '" + text + "', expected KEY=VALUE"));
  }
}

TEST(SwarmCommand, ReadsTheFirstSeedWhereverItStands) {
  EXPECT_EQ(parseSwarmFunctions({"7"}).first_seed, 1);
  EXPECT_EQ(parseSwarmFunctions({"--first-seed", "101", "7", "race.png"}).first_seed, 101);
  EXPECT_EQ(parseSwarmFunctions({"--first-seed", "101", "7", "race.png"}).plot_file, "race.png");
  const SwarmFixPlan plan = parseSwarmFixes({"w.yaml", "0.1", "--first-seed", "41", "9"}).plan;
  EXPECT_EQ(plan.first_seed, 41);
  EXPECT_EQ(plan.runs, 9);
  EXPECT_EQ(parseSwarmFixes({"w.yaml", "0.1"}).plan.first_seed, 1);
  for (const std::string text : {"abc", "0", "-3", "1.5", ""}) {
    EXPECT_THAT(refusedFixes({"w.yaml", "0.1", "--first-seed", text}),
                HasSubstr("--first-seed: got '" + text + "'"));
  }
  EXPECT_THAT(refusedFunctions({"7", "--first-seed"}), HasSubstr("--first-seed"));
}

TEST(SwarmCommand, ReadsWhichSwarmsAndFiltersTakePart) {
  const SwarmFixPlan all = parseSwarmFixes({"w.yaml", "0.1"}).plan;
  EXPECT_EQ(all.swarms, swarmNames());
  const auto command = parseSwarmFixes({"w.yaml", "0.1", "9", "--filter", "mcl/fp", "--searchers",
                                        "20", "--searchers", "400", "--json", "fixes.json",
                                        "--updates", "7", "--noise", "0"});
  EXPECT_EQ(command.plan.updates, 7);
  EXPECT_EQ(all.updates, 500);
  EXPECT_EQ(command.plan.noise, 0.0);
  EXPECT_EQ(all.noise, 0.031);
  EXPECT_THAT(command.plan.swarms, testing::IsEmpty());
  EXPECT_THAT(command.plan.filters, testing::ElementsAre("mcl/fp"));
  EXPECT_THAT(command.plan.searchers, testing::ElementsAre(20, 400));
  EXPECT_EQ(command.plan.starts, all.starts);
  EXPECT_EQ(command.json_file, "fixes.json");
  const SwarmFixPlan one =
      parseSwarmFixes({"w.yaml", "0.1", "--swarm", "pso", "--start", "ser"}).plan;
  EXPECT_THAT(one.swarms, testing::ElementsAre("pso"));
  EXPECT_THAT(one.filters, testing::IsEmpty());
  EXPECT_THAT(one.starts, testing::ElementsAre("ser"));
  EXPECT_THAT(refusedFixes({"w.yaml", "0.1", "--searchers", "many"}),
              HasSubstr("--searchers: got 'many'"));
  EXPECT_THAT(refusedFixes({"w.yaml", "0.1", "--swarm"}), HasSubstr("--swarm"));
}

TEST(SwarmCommand, HelpsWhereverItIsAsked) {
  EXPECT_TRUE(parseSwarmFunctions({"x", "--help"}).wants_help);
  EXPECT_TRUE(parseSwarmFixes({"-h"}).wants_help);
  EXPECT_THAT(swarmFunctionsUsage(), HasSubstr("usage: swarm_functions [SEEDS"));
  EXPECT_THAT(swarmFixesUsage(), HasSubstr("usage: swarm_fixes WORLD.yaml RESOLUTION"));
}

TEST(SwarmCommand, RefusesWhatIsWrongAndNamesIt) {
  for (const std::string text : {"abc", "0.1x", "", "0", "-1", "nan", "1e9"}) {
    EXPECT_THAT(refusedFixes({"w.yaml", text}), HasSubstr("RESOLUTION: got '" + text + "'"));
  }
  for (const std::string text : {"abc", "3x", "0", "-1", "1.5", "100001", ""}) {
    EXPECT_THAT(refusedFixes({"w.yaml", "0.1", text}), HasSubstr("RUNS: got '" + text + "'"));
    EXPECT_THAT(refusedFunctions({text}), HasSubstr("SEEDS: got '" + text + "'"));
  }
  EXPECT_THAT(refusedFixes({"w.yaml", "0.1", "3", "sphere"}),
              AllOf(HasSubstr("sphere"), HasSubstr("expected torus")));
  EXPECT_THAT(refusedFixes({}), HasSubstr("WORLD.yaml is missing"));
  EXPECT_THAT(refusedFixes({"w.yaml"}), HasSubstr("RESOLUTION is missing"));
  EXPECT_THAT(refusedFixes({"w.yaml", "0.1", "3", "torus", "more"}), HasSubstr("'more'"));
  EXPECT_THAT(refusedFunctions({"3", "x.png", "more"}), HasSubstr("'more'"));
}

}  // namespace
}  // namespace adaptive_localization
