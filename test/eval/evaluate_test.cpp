// SPDX-License-Identifier: BSD-3-Clause
// scripts/evaluate, as somebody uses it who has recordings of their own.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "toy_replay.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// A folder of recordings: one in one place.
class Evaluate : public Replay {
 protected:
  Evaluate() {
    setenv("REPLAY", REPLAY, 1);
    place_ = folder_.file("recordings/room");
    std::filesystem::create_directories(place_);
    for (const auto& file : std::filesystem::directory_iterator(folder_.file(""))) {
      if (file.path().stem() == "room" && file.is_regular_file()) bring(file.path(), "");
    }
    bring(log_, "drive.clf");
    bring(truth_, "drive_reference.tum");
  }

  void bring(const std::filesystem::path& file, const std::string& name) const {
    const std::string other = name.empty() ? file.filename().string() : name;
    std::filesystem::copy_file(file, std::filesystem::path(place_) / other);
  }

  ProgramResult evaluate(std::vector<std::string> more) const {
    more.insert(more.begin(), {"--data", folder_.file("recordings")});
    return runProgram(SOURCE_DIR "/scripts/evaluate", more);
  }

  std::string place_;
};

TEST_F(Evaluate, ReplaysAFolderOfRecordings) {
  const ProgramResult result = evaluate({"--seeds", "2", "--filter", "kld"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, ContainsRegex(R"(\| kld \| room drive \| 0\.0[0-9]+ \|)"));
  EXPECT_THAT(result.output, HasSubstr("| 0/2 | 2/2, 0.0 s |"));
}

TEST_F(Evaluate, RunsTheSeedsThatItIsTold) {
  const std::string results = folder_.file("results.json");
  const ProgramResult done = evaluate({"--seeds", "2", "--first-seed", "3", "--json", results});
  ASSERT_EQ(done.exit_code, 0) << done.errors;
  const auto runs = nlohmann::json::parse(std::ifstream(results));
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].at("seed"), 3);
  EXPECT_EQ(runs[1].at("seed"), 4);
}

TEST_F(Evaluate, TellsWhereARobotGetsLostOnAPoorMap) {
  const ProgramResult result =
      evaluate({"--seeds", "1", "--filter", "kld", "--spoil", "none", "--spoil", "shift:1"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, ContainsRegex(R"(\| none \| kld \| room drive \| 0\.0.*\| 0/1 \|)"));
  EXPECT_THAT(result.output, ContainsRegex(R"(\| shift:1 \| kld \| room drive \| .*\| 1/1 \|)"));
}

TEST_F(Evaluate, TellsWhatItCosts) {
  const ProgramResult result = evaluate({"--seeds", "1", "--filter", "kld", "--cost"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("longest after the first scan"));
  EXPECT_THAT(result.output,
              ContainsRegex(R"(\| none \| kld \| room drive \|( [0-9]+\.?[0-9]* \|){6})"));
}

TEST_F(Evaluate, NamesWhatIsWrong) {
  const auto expectRefused = [&](const std::vector<std::string>& arguments,
                                 const std::string& why) {
    const ProgramResult result = evaluate(arguments);
    EXPECT_NE(result.exit_code, 0) << why;
    EXPECT_THAT(result.errors, AllOf(HasSubstr("evaluate: " + why), Not(HasSubstr("Traceback"))));
  };
  expectRefused({"--seeds", "0"}, "--seeds: got 0, expected at least 1");
  expectRefused({"--first-seed", "0"}, "--first-seed: got 0, expected at least 1");
  expectRefused({"--jobs", "0"}, "--jobs: got 0, expected at least 1");
  expectRefused({"--spoil", "thik"}, "--spoil: got 'thik', expected all or one of none, thick");
  expectRefused({"--window", "attic"}, "no recording with a map and a reference in ");
  std::filesystem::remove(place_ + "/drive_reference.tum");
  expectRefused({}, place_ + "/drive.clf is left out: expected one map");
}

TEST_F(Evaluate, TellsWhyARunFailed) {
  const ProgramResult result = evaluate({"--seeds", "1", "--filter", "nobody"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.errors, HasSubstr("nobody"));
}

}  // namespace
}  // namespace adaptive_localization
