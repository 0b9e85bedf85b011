// SPDX-License-Identifier: BSD-3-Clause
// The executable as its user meets it.
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "eval/experiment_command.hpp"
#include "eval/experiment_file.hpp"
#include "support/program.hpp"
#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class Experiments : public testing::Test {
 protected:
  Experiments()
      : experiment_(toy_.write("duration: 4\nseeds: {first: 1, count: 5}\n"
                               "events: [{what: kidnap, at: 2, to: random}]\n"
                               "options: {update_min_d: 0, update_min_a: 0}\n"
                               "cores: [{filter: kld}, {filter: amcl}]\n")) {}

  ProgramResult run(const std::string& out, std::vector<std::string> more) const {
    more.insert(more.begin(), {experiment_, "--out", file(out)});
    return runProgram(EXPERIMENTS, more);
  }

  std::string file(const std::string& name) const { return toy_.folder().file(name); }

  /// A file's runs in order, without the times that updates took.
  std::vector<std::string> runsIn(const std::string& out) const {
    std::istringstream text(readWhole(file(out)));
    std::vector<std::string> runs;
    for (std::string line; std::getline(text, line);) {
      auto run = nlohmann::json::parse(line);
      run.erase("update_ms_median");
      run.erase("update_ms_max");
      runs.push_back(run.dump());
    }
    std::sort(runs.begin(), runs.end());
    return runs;
  }

  ToyExperiment toy_;
  std::string experiment_;
};

TEST_F(Experiments, WriteOneLinePerRun) {
  const ProgramResult result = run("o.jsonl", {"--jobs", "2"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, IsEmpty());
  EXPECT_THAT(runsIn("o.jsonl"), testing::SizeIs(10));
  const ProgramResult summary =
      runProgram(SOURCE_DIR "/scripts/summarize",
                 {file("o.jsonl"), "--json", file("o.json"), "--plot", file("o.png")});
  ASSERT_EQ(summary.exit_code, 0) << summary.errors;
  EXPECT_THAT(summary.output, AllOf(HasSubstr("toy:\n"), HasSubstr("| amcl | 5 |")));
  const auto json = nlohmann::json::parse(readWhole(file("o.json")));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0].at("core"), "amcl");
  EXPECT_EQ(json[0].at("found").at("of"), 10) << "starts and kidnaps";
  EXPECT_THAT(readWhole(file("o.png")), HasSubstr("PNG"));
}

TEST_F(Experiments, GiveTheSameForAnyNumberOfJobsAndAfterAnInterruption) {
  ASSERT_EQ(run("one.jsonl", {"--jobs", "1", "--quiet"}).exit_code, 0);
  ASSERT_EQ(run("three.jsonl", {"--jobs", "3", "--quiet"}).exit_code, 0);
  EXPECT_EQ(runsIn("one.jsonl"), runsIn("three.jsonl"));

  const std::string whole = readWhole(file("one.jsonl"));
  toy_.folder().write("cut.jsonl", whole.substr(0, whole.size() / 2));
  const ProgramResult result = run("cut.jsonl", {});
  ASSERT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, HasSubstr("of 10 runs are there already"));
  EXPECT_EQ(runsIn("cut.jsonl"), runsIn("one.jsonl"));
}

TEST_F(Experiments, MergeByConcatenation) {
  ASSERT_EQ(run("one.jsonl", {"--quiet"}).exit_code, 0);
  std::string merged;
  for (const std::string shard : {"1", "2", "3"}) {
    ASSERT_EQ(run(shard + ".jsonl", {"--shard", shard + "/3", "--quiet"}).exit_code, 0);
    merged += readWhole(file(shard + ".jsonl"));
  }
  toy_.folder().write("merged.jsonl", merged);
  EXPECT_EQ(runsIn("merged.jsonl"), runsIn("one.jsonl"));
}

TEST_F(Experiments, RunUnderGnuParallelAsInOneProcess) {
  ASSERT_THAT(runProgram("parallel", {"--version"}).output, testing::HasSubstr("GNU parallel"))
      << "scripts/setup installs it";
  ASSERT_EQ(run("one.jsonl", {"--quiet"}).exit_code, 0);
  const ProgramResult result = runProgram(
      "parallel", {"--will-cite", "--jobs", "2", EXPERIMENTS, experiment_, "--quiet", "--jobs", "1",
                   "--shard", "{}/4", "--out", file("part.{}.jsonl"), ":::", "1", "2", "3", "4"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::string merged;
  for (const std::string part : {"1", "2", "3", "4"}) {
    merged += readWhole(file("part." + part + ".jsonl"));
  }
  toy_.folder().write("merged.jsonl", merged);
  EXPECT_EQ(runsIn("merged.jsonl"), runsIn("one.jsonl"));
}

TEST_F(Experiments, KeepOthersAwayFromTheirResults) {
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const pid_t other = fork();
  if (other == 0) {
    const ExperimentFile results(file("a.jsonl"));
    (void)!write(pipe_ends[1], "x", 1);
    for (;;) pause();
  }
  char begun = 0;
  ASSERT_EQ(read(pipe_ends[0], &begun, 1), 1);
  const auto second = run("a.jsonl", {"--quiet"});
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.errors,
              AllOf(HasSubstr("results '" + file("a.jsonl")), HasSubstr("another program")));
  EXPECT_EQ(run("b.jsonl", {"--shard", "1/2", "--quiet"}).exit_code, 0);
  EXPECT_THAT(runsIn("a.jsonl"), IsEmpty());
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
  EXPECT_EQ(run("a.jsonl", {"--quiet"}).exit_code, 0);
  EXPECT_EQ(runsIn("a.jsonl").size(), 10U);
}

TEST_F(Experiments, SayWhatTheyWouldRun) {
  const ProgramResult result =
      runProgram(EXPERIMENTS, {experiment_, "--list", "--seeds", "7", "--only", "amcl"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, testing::EndsWith("/amcl: 7 runs\n"));
  EXPECT_THAT(result.output, testing::Not(HasSubstr("kld")));
  const auto listed = [&](const std::string& word) {
    return runProgram(EXPERIMENTS, {experiment_, "--list", "--only", word}).output;
  };
  EXPECT_THAT(listed("amc"), HasSubstr("/amcl: "));
  EXPECT_THAT(listed("amc$"), testing::Not(HasSubstr("/amcl")));
  EXPECT_EQ(listed("/amcl$"), listed("amcl"));
}

TEST_F(Experiments, AreKeptHereUnderTheirNameUnlessToldOtherwise) {
  EXPECT_EQ(parseExperimentCommand({"config/one.yaml", "two.yaml"}).out_file, "one.jsonl");
  EXPECT_EQ(parseExperimentCommand({"one.yaml", "--out", "there.jsonl"}).out_file, "there.jsonl");
}

TEST_F(Experiments, SayWhatIsWrong) {
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& why) {
    const ProgramResult result = runProgram(EXPERIMENTS, arguments);
    EXPECT_EQ(result.exit_code, 1) << why;
    EXPECT_THAT(result.errors, AllOf(HasSubstr("experiments: "), HasSubstr(why)));
    EXPECT_THAT(result.output, IsEmpty());
  };
  const std::string out = file("x.jsonl");
  expect({}, "no file is given");
  expect({experiment_, "--out"}, "--out needs a value");
  expect({experiment_, "--out", out, "--nosuch"}, "unknown argument '--nosuch'");
  expect({experiment_, "--uot", out}, "unknown argument '--uot'; did you mean '--out'?");
  expect({experiment_, "--out", out, "--only", "sakld"}, "--only: got 'sakld', expected a word of");
  expect({experiment_, "--out", out, "--jobs", "0"}, "--jobs: got '0', expected a whole number");
  expect({experiment_, "--out", out, "--seeds", "2x"}, "--seeds: got '2x'");
  for (const std::string shard : {"3", "0/2", "3/2", "a/2", "1/"}) {
    expect({experiment_, "--out", out, "--shard", shard}, "--shard: got '" + shard + "'");
  }
  expect({experiment_, "--out", experiment_}, "toy.yaml', line 1: no result");
  expect({file("nosuch.yaml"), "--out", out}, "nosuch.yaml");
  expect({experiment_, "--out", out, "duration:=soon"}, "'duration': got 'soon'");
  expect({experiment_, "--out", out, "nosuch_option:=1"}, "unknown option 'nosuch_option'");
  expect({experiment_, "--out", out, "lazer_max_beams:=30"}, "did you mean 'laser_max_beams'?");
  expect({experiment_, "--out", file("no/such/x.jsonl")}, "cannot be written");
  EXPECT_EQ(runProgram(EXPERIMENTS, {"--help"}).output, experimentUsage());
}

}  // namespace
}  // namespace adaptive_localization
