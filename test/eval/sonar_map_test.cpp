// SPDX-License-Identifier: BSD-3-Clause
// The program sonar_map, by what it says and writes.
#include "eval/sonar_map.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/sonar_map_command.hpp"
#include "support/program.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using testing::ThrowsMessage;
using Arguments = std::vector<std::string>;

const std::string kWorld = std::string(SOURCE_DIR) + "/maps/maze/world.yaml";

class SonarMapProgram : public testing::Test {
 protected:
  static ProgramResult run(Arguments arguments) {
    arguments.insert(arguments.begin(), {"--world", kWorld});
    return runProgram(SONAR_MAP, arguments);
  }
  nlohmann::json numbers(Arguments arguments) const {
    arguments.insert(arguments.end(), {"--json", file("numbers.json")});
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(readWhole(file("numbers.json")));
  }
  std::string file(const std::string& name) const { return folder_.file(name); }

 private:
  TempFolder folder_;
};

/// The floors are a tenth below what was measured for seed 1.
TEST_F(SonarMapProgram, FindsTheWallsOfTheMaze) {
  const auto rows = numbers({});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0]["model"], "moravec-elfes");
  EXPECT_EQ(rows[1]["model"], "elfes");
  EXPECT_EQ(rows[2]["model"], "konolige");
  EXPECT_GT(rows[0]["f_score"], 0.59);
  EXPECT_GT(rows[1]["f_score"], 0.70);
  EXPECT_GT(rows[2]["f_score"], 0.69);
  for (const auto& row : rows) EXPECT_GT(row["correct_share"], 0.7);
}

TEST_F(SonarMapProgram, KonoligesModelForgivesMirrors) {
  const auto rows = numbers({"evidence_reach:=20"});
  EXPECT_GT(rows[2]["f_score"], rows[0]["f_score"].get<double>() + 0.1);
  EXPECT_GT(rows[2]["f_score"], rows[1]["f_score"].get<double>() + 0.1);
}

TEST_F(SonarMapProgram, SameSeedSameMap) {
  const Arguments arguments{"--seconds", "20", "--seed", "3"};
  const ProgramResult first = run(arguments);
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_EQ(run(arguments).output, first.output);
  EXPECT_NE(run({"--seconds", "20", "--seed", "4"}).output, first.output);
}

TEST_F(SonarMapProgram, PosesByOdometryMakePoorerMaps) {
  const Arguments arguments{"--seconds", "200", "--model", "konolige", "profile:=bad"};
  Arguments by_odometry = arguments;
  by_odometry.insert(by_odometry.end(), {"--poses", "odometry"});
  EXPECT_LT(numbers(by_odometry)[0]["f_score"], numbers(arguments)[0]["f_score"]);
}

TEST_F(SonarMapProgram, WritesMapsThatLoad) {
  const ProgramResult result =
      run({"--seconds", "20", "--resolution", "0.1", "--out", file("out")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, AllOf(StartsWith("1000 readings\n"), HasSubstr("\nmoravec-elfes "),
                                   HasSubstr("\nelfes "), HasSubstr("\nkonolige ")));
  EXPECT_THAT(result.errors, IsEmpty());
  for (const std::string model : {"moravec-elfes", "elfes", "konolige"}) {
    const OccupancyGrid map = loadMap(file("out/" + model + "/map.yaml"));
    EXPECT_TRUE(map.lattice() == trueMapOf(kWorld, 0.1).lattice());
    EXPECT_GT(map.countFree(), 100U) << model;
    const cv::Mat grey = cv::imread(file("out/" + model + "/probability.pgm"));
    EXPECT_EQ(grey.size(), cv::Size(map.lattice().width(), map.lattice().height()));
  }
  const ProgramResult drawn = runProgram(SOURCE_DIR "/scripts/draw", {file("out/maps.json")});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.errors;
  EXPECT_GT(cv::imread(file("out/maps.png")).rows, 500);
}

TEST_F(SonarMapProgram, DrawsWhatOneReadingTells) {
  const ProgramResult result =
      runProgram(SONAR_MAP, {"--profile", file("profile.json"), "sonar_max_range:=4"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const ProgramResult drawn =
      runProgram(SOURCE_DIR "/scripts/draw", {file("profile.json"), file("p.png")});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.errors;
  EXPECT_GT(cv::imread(file("p.png")).rows, 700);
}

TEST_F(SonarMapProgram, NamesWhatIsWrong) {
  const auto expectError = [](const ProgramResult& result, const std::string& why) {
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, AllOf(StartsWith("sonar_map: "), HasSubstr(why)));
  };
  expectError(runProgram(SONAR_MAP, {"--world", "/none.yaml"}), "'/none.yaml'");
  expectError(run({"evidence_free:=0.2"}), "it is always 0.35");
  expectError(run({"sonars:=false"}), "option 'sonars': got false, expected true");
  expectError(run({"--truth", "/none.yaml"}), "'/none.yaml'");
  expectError(run({"start:=99,99,0"}), "option 'start': got 99");
  expectError(run({"--seconds", "1", "--json", "/none/x.json"}), "'/none/x.json'");
  expectError(runProgram(SONAR_MAP, {"--bag", "/none.bag", "--poses", "odometry"}), "'/none.bag'");
}

TEST(SonarMapCommand, RefusesWhatItDoesNotKnow) {
  const auto expectRejected = [](Arguments arguments, const std::string& why) {
    arguments.insert(arguments.begin(), {"--world", "w.yaml"});
    EXPECT_THAT([&] { parseSonarMapCommand(arguments); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
  };
  expectRejected({"--model", "bayes"}, "--model: got 'bayes', expected all, moravec-elfes");
  expectRejected({"--poses", "guess"}, "--poses: got 'guess', expected truth or odometry");
  expectRejected({"--seconds", "0"}, "--seconds: got '0', expected 0.1 to 100000 seconds");
  expectRejected({"--resolution", "2"}, "--resolution: got '2', expected 0.005 to 1 m");
  expectRejected({"--seed", "-1"}, "--seed: got '-1'");
  expectRejected({"more"}, "got 'more', expected KEY:=VALUE");
  expectRejected({"sonar_mirrorangle:=1"}, "did you mean 'sonar_mirror_angle'?");
  expectRejected({"evidence_trust:=2"}, "'evidence_trust': got '2'");
  expectRejected({"--bag", "x.bag"}, "--world and --bag exclude each other");
  expectRejected({"--truth-topic", "t"}, "--truth-topic is of use with --bag alone");
  EXPECT_THAT([] { parseSonarMapCommand({}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("--world or --bag is missing")));
  EXPECT_THAT(
      [] {
        parseSonarMapCommand({"--bag", "x.bag"});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("--bag needs --truth-topic")));
}

TEST(SonarMapCommand, HelpNeedsNothingElse) {
  const auto result = runProgram(SONAR_MAP, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, AllOf(StartsWith("usage: sonar_map"), HasSubstr("evidence_sigma")));
}

/// A recorded drive, past a wall on the left.
Log passing(bool has_reference, bool has_sonar = true) {
  Log log;
  for (int i = 0; i < 100; ++i) {
    LogScan scan;
    scan.T_odom_base = {0.03 * i, 0.0, 0.0};
    if (has_reference && i >= 10) scan.T_map_base = Pose2{5.0, 0.03 * i, kPi / 2.0};
    if (has_sonar) scan.sonar = {{0, {0.0, 0.0, kPi / 2.0}, 1.0, 5.0, 0.4}};
    log.scans.push_back(scan);
  }
  return log;
}

TEST(SonarDriveOfALog, IsPlacedByReferenceOrOdometry) {
  const SonarDrive by_truth = driveOf(passing(true), Poses::kTruth);
  EXPECT_EQ(by_truth.readings.size(), 90U);  // where there is a reference
  const SonarDrive by_odometry = driveOf(passing(false), Poses::kOdometry);
  EXPECT_EQ(by_odometry.readings.size(), 100U);
  for (const auto& [drive, wall] : {std::pair{by_truth, Eigen::Vector2d(4.0, 1.5)},
                                    std::pair{by_odometry, Eigen::Vector2d(1.5, 1.0)}}) {
    const Lattice lattice = latticeAround(drive, {}, 0.05);
    const SonarMap map = makeSonarMap("elfes", {}, drive, lattice, std::nullopt);
    EXPECT_FALSE(map.score);
    EXPECT_GT(map.grid->probability(lattice.cellAt(wall)), 0.8);
    const Eigen::Vector2d driven(drive.path[50].x, drive.path[50].y);
    EXPECT_LT(map.grid->probability(lattice.cellAt(0.5 * (driven + wall))), 0.2);
  }
}

TEST(SonarDriveOfALog, NeedsReadingsAndPoses) {
  EXPECT_THAT([] { driveOf(passing(true, false), Poses::kTruth); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("sonar_topics:=TOPIC")));
  EXPECT_THAT([] { driveOf(passing(false), Poses::kTruth); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("poses to place it by")));
}

}  // namespace
}  // namespace adaptive_localization
