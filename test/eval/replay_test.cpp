// SPDX-License-Identifier: BSD-3-Clause
// The executable as its user meets it: a small log in a square room.
#include <nlohmann/json.hpp>

#include "eval/statistics.hpp"
#include "toy_replay.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(Replay, FollowsADriveAndWritesAll) {
  const ProgramResult result =
      replay({"--truth", truth_, "--seed", "3", "--json", folder_.file("o.json"), "--trajectory",
              folder_.file("o.tum")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, IsEmpty());
  EXPECT_THAT(result.output, HasSubstr("kld: 40 scans"));
  const auto json = nlohmann::json::parse(readWhole(folder_.file("o.json")));
  EXPECT_EQ(json.at("seed"), 3);
  EXPECT_EQ(json.at("scans"), kSteps);
  EXPECT_LT(json.at("ate_rmse_m").get<double>(), 0.1);
  EXPECT_DOUBLE_EQ(json.at("lost_share").get<double>(), 0.0);
  std::vector<std::string> warnings;
  EXPECT_EQ(loadTum(folder_.file("o.tum"), warnings).poses().size(), 40U);
}

TEST_F(Replay, SearchesSingleScansInTheWholeMap) {
  const ProgramResult result =
      replay({"--truth", truth_, "--search", "10", "--json", folder_.file("o.json")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("10 scans, each alone"));
  const auto json = nlohmann::json::parse(readWhole(folder_.file("o.json")));
  EXPECT_EQ(json.at("scans"), 10);
  EXPECT_EQ(json.at("among"), 10);
  EXPECT_EQ(json.at("ambiguous"), 10) << "the room looks the same after half a turn";
  EXPECT_EQ(json.at("nowhere"), 0);
}

TEST_F(Replay, GivesTheSameBitsAgainAndForAnyNumberOfThreads) {
  std::vector<std::string> trajectories;
  for (const char* threads : {"1", "1", "2", "4"}) {
    ASSERT_EQ(replay({"--truth", truth_, "--seed", "2", "--threads", threads, "--trajectory",
                      folder_.file("o.tum")})
                  .exit_code,
              0);
    trajectories.push_back(readWhole(folder_.file("o.tum")));
  }
  EXPECT_GT(trajectories[0].size(), 1000U);
  for (const auto& trajectory : trajectories) EXPECT_EQ(trajectory, trajectories[0]);
  ASSERT_EQ(
      replay({"--truth", truth_, "--seed", "3", "--trajectory", folder_.file("o.tum")}).exit_code,
      0);
  EXPECT_NE(readWhole(folder_.file("o.tum")), trajectories[0]) << "another seed, another run";
}

TEST_F(Replay, StartsAtAPoseOrAnywhereWithoutReference) {
  for (const char* start : {"1.5,1.2,0", "global"}) {
    const ProgramResult result = replay({"--start", start, "--json", folder_.file("o.json")});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_TRUE(
        nlohmann::json::parse(readWhole(folder_.file("o.json"))).at("ate_rmse_m").is_null());
  }
}

TEST_F(Replay, IsQuietIfAsked) {
  const ProgramResult result = replay({"--truth", truth_, "--quiet"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST_F(Replay, ReplacesNothingThatItReads) {
  const std::string options = folder_.write("options.yaml", "update_min_d: 0.2\n");
  const auto expectRefused = [&](const std::string& option, const std::string& output,
                                 const std::string& input) {
    const std::string before = readWhole(input);
    const ProgramResult result = replay({"--truth", truth_, "--params", options, option, output});
    EXPECT_EQ(result.exit_code, 1) << option;
    EXPECT_THAT(result.errors, HasSubstr("is the input '" + input + "', expected another file"));
    EXPECT_EQ(readWhole(input), before) << option;
  };
  expectRefused("--trajectory", truth_, truth_);
  expectRefused("--json", log_, log_);
  expectRefused("--json", options, options);
  saveMap(loadMap(map_), folder_.file("map"));
  map_ = folder_.file("map.yaml");
  expectRefused("--report", folder_.file(""), folder_.file("map.pgm"));
}

TEST_F(Replay, SaysWhereItStarts) {
  EXPECT_THAT(replay({"--truth", truth_}).output,
              HasSubstr("started at (1.500, 1.200) m, 0.0 deg, as the reference says"));
  EXPECT_THAT(replay({"--start", "1.5,1.2,0"}).output,
              HasSubstr("started at (1.500, 1.200) m, 0.0 deg;"));
  EXPECT_THAT(replay({"--start", "global"}).output, HasSubstr("started anywhere on the map;"));
}

TEST_F(Replay, SpoilsMapAndLogIfAsked) {
  const ProgramResult result =
      replay({"--truth", truth_, "--seed", "3", "--spoil", "shift:0.1", "lost:0.5", "--spoil",
              "scale", "--json", folder_.file("o.json")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("spoiled by shift:0.1, lost:0.5, scale:0.02;"));
  const auto json = nlohmann::json::parse(readWhole(folder_.file("o.json")));
  EXPECT_EQ(json.at("spoil"), "shift:0.1, lost:0.5, scale:0.02");
  EXPECT_EQ(json.at("spoil_seed"), 3);
  EXPECT_LT(json.at("scans"), kSteps - 5);
  EXPECT_NEAR(json.at("ate_median_m").get<double>(), 0.1 * std::sqrt(2.0), 0.03)
      << "the reference stays in the frame of the map that was given";
}

TEST_F(Replay, SpoilsByTheRunsSeedOrOneOfItsOwn) {
  const auto scansWith = [&](const std::vector<std::string>& seeds) {
    std::vector<std::string> all{"--truth",  truth_,         "--spoil",
                                 "lost:0.5", "--trajectory", folder_.file("o.tum")};
    all.insert(all.end(), seeds.begin(), seeds.end());
    EXPECT_EQ(replay(all).exit_code, 0);
    std::vector<std::string> warnings;
    const Trajectory estimates = loadTum(folder_.file("o.tum"), warnings);
    return valuesOf(estimates.poses(), &StampedPose::stamp);
  };
  const auto third = scansWith({"--seed", "3"});
  EXPECT_EQ(scansWith({"--seed", "4", "--spoil-seed", "3"}), third);
  EXPECT_EQ(scansWith({"--set", "seed=3"}), third);
  EXPECT_NE(scansWith({"--seed", "4"}), third);
}

TEST_F(Replay, NamesWhatWasSpoiledWhereScansDoNotFit) {
  const std::string corridor = saveRoom("corridor", 204, 20);
  const ProgramResult result = runProgram(
      REPLAY, {"--map", corridor, "--log", log_, "--start", "global", "--spoil", "dotted:0.1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("do not fit the map '" + corridor +
                                       "', spoiled by dotted:0.1: no place explains"));
}

TEST_F(Replay, HelpsOnStandardOutput) {
  const ProgramResult result = runProgram(REPLAY, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("usage: replay --map MAP.yaml --log FILE"));
  EXPECT_THAT(result.output, HasSubstr("  slip     7.5 deg   odometry turns by this"));
}

TEST_F(Replay, TakesScansAsTheyShouldHaveBeenStampedAndMounted) {
  const auto error = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--truth", truth_, "--json", folder_.file("o.json"), "--quiet"});
    const ProgramResult result = replay(more);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(readWhole(folder_.file("o.json"))).at("ate_rmse_m").get<double>();
  };
  EXPECT_GT(error({"--mount", "0.3,0,0"}), error({"--mount", "0,0,0"}) + 0.1);
  EXPECT_GT(error({"--spoil", "late:1"}), 0.1);
  EXPECT_LT(error({"--spoil", "late:1", "--set", "scan_time_offset=-1"}), 0.05);
  expectRejected({"--map", map_, "--log", log_, "--set", "scan_time_offset=9"},
                 "'scan_time_offset': got 9");
}

TEST_F(Replay, KeepsTheWholeRunForAReport) {
  const std::string folder = folder_.file("report");
  const ProgramResult result = replay({"--truth", truth_, "--report", folder, "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const std::string scans = readWhole(folder + "/scans.csv");
  EXPECT_EQ(std::count(scans.begin(), scans.end(), '\n'), kSteps + 1);
  EXPECT_THAT(scans, StartsWith("stamp,x,y,yaw,"));
  EXPECT_THAT(scans, HasSubstr(",tracking,"));
  const auto views = nlohmann::json::parse(readWhole(folder + "/views.json"));
  ASSERT_GT(views.size(), 20U);
  EXPECT_LE(views.size(), static_cast<std::size_t>(kSteps));
  EXPECT_GT(views[0].at("hits").size(), 100U);
  EXPECT_LT(views[0].at("hits")[0][2], 0.1) << "a hit is on a wall";
  EXPECT_GT(views[0].at("particles").size(), 50U);
  const auto numbers = nlohmann::json::parse(readWhole(folder + "/run.json"));
  double shares = 0.0;
  for (const auto& entry : numbers.at("status").items()) shares += entry.value().get<double>();
  EXPECT_NEAR(shares, 1.0, 1e-9);
  EXPECT_EQ(loadMap(folder + "/map.yaml").lattice().width(), 124);

  const ProgramResult page =
      runProgram(SOURCE_DIR "/scripts/report", {folder, "--picture", folder_.file("drive.png")});
  ASSERT_EQ(page.exit_code, 0) << page.errors;
  const std::string text = readWhole(folder + "/report.html");
  EXPECT_THAT(text, HasSubstr("The drive"));
  EXPECT_EQ(readWhole(folder_.file("drive.png")).compare(1, 3, "PNG"), 0);
  EXPECT_THAT(text, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(text, Not(HasSubstr("http"))) << "everything is in it";

  const ProgramResult wrong = runProgram(SOURCE_DIR "/scripts/report", {folder_.file("nosuch")});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_THAT(wrong.errors, HasSubstr("nosuch"));
}

}  // namespace
}  // namespace adaptive_localization
