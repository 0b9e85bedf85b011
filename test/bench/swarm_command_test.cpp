// SPDX-License-Identifier: BSD-3-Clause
// What the executables say to arguments that are wrong.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

const Arguments kFixes{"--world", SOURCE_DIR "/maps/simple/world.yaml", "--json", "x.json"};

std::string refused(const char* program, Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramResult result = runProgram(program, arguments);
  EXPECT_EQ(result.exit_code, 1) << result.output;
  return result.errors;
}

TEST(SwarmCommand, RunsWhatIsAskedFor) {
  const TempFolder folder;
  const std::string file = folder.file("fixes.json");
  const ProgramResult result = runProgram(
      SWARM_FIXES,
      {"--world", kFixes[1], "--resolution", "0.2",     "--runs",      "2",      "--first-seed",
       "41",      "--torus", "--searchers",  "20",      "--searchers", "40",     "--swarm",
       "pso",     "--start", "free",         "--noise", "0",           "--json", file});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(readWhole(file));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[1].at("searchers"), 40);
  EXPECT_EQ(json[1].at("start"), "free");
  EXPECT_EQ(json[1].at("core"), "pso");
  EXPECT_EQ(json[1].at("runs").size(), 2U);
  EXPECT_EQ(json[1].at("runs")[1].at("seed"), 42);
}

TEST(SwarmCommand, RefusesWhatIsWrongAndNamesIt) {
  for (const std::string text : {"abc", "0.1x", "", "0", "-1", "nan", "1e9"}) {
    EXPECT_THAT(refused(SWARM_FIXES, kFixes, {"--resolution", text}),
                HasSubstr("--resolution: got '" + text + "'"));
  }
  for (const std::string text : {"abc", "3x", "0", "-1", "1.5", "100001", ""}) {
    EXPECT_THAT(refused(SWARM_FIXES, kFixes, {"--runs", text}),
                HasSubstr("--runs: got '" + text + "'"));
    EXPECT_THAT(refused(SWARM_FUNCTIONS, {"--json", "x.json"}, {"--seeds", text}),
                HasSubstr("--seeds: got '" + text + "'"));
  }
  for (const std::string text : {"swarm_beams", "=9", ""}) {
    EXPECT_THAT(refused(SWARM_FIXES, kFixes, {"--set", text}),
                HasSubstr("--set: got '" + text + "', expected KEY=VALUE"));
  }
  EXPECT_THAT(refused(SWARM_FIXES, kFixes, {"--searchers", "many"}),
              HasSubstr("--searchers: got 'many'"));
  EXPECT_THAT(refused(SWARM_FIXES, kFixes, {"--swarm"}), HasSubstr("--swarm needs a value"));
  EXPECT_THAT(refused(SWARM_FIXES, kFixes, {"sphere"}), HasSubstr("'sphere'"));
  EXPECT_THAT(refused(SWARM_FIXES, {}, {"--json", "x.json"}), HasSubstr("--world is missing"));
  EXPECT_THAT(refused(SWARM_FIXES, {}, {"--world", "x.yaml"}), HasSubstr("--json is missing"));
  EXPECT_THAT(refused(SWARM_FUNCTIONS, {}, {}), HasSubstr("--json is missing"));
}

TEST(SwarmCommand, HelpsWhereverItIsAsked) {
  EXPECT_THAT(runProgram(SWARM_FUNCTIONS, {"--seeds", "3", "--help"}).output,
              HasSubstr("usage: swarm_functions"));
  EXPECT_THAT(runProgram(SWARM_FIXES, {"-h"}).output, HasSubstr("usage: swarm_fixes"));
}

}  // namespace
}  // namespace adaptive_localization
