// SPDX-License-Identifier: BSD-3-Clause
// The executable as its user meets it: a small log in a square room.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "adaptive_localization/eval/trajectory.hpp"
#include "adaptive_localization/map/map_io.hpp"
#include "support/program.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kRoomWidth = 6.0, kRoomHeight = 4.0;  // m, walls at 0 and there
constexpr int kSteps = 40;

/// Distance along one axis, moving at `speed` between walls at 0 and `width`.
double axisDistance(double at, double width, double speed) {
  if (speed == 0.0) return std::numeric_limits<double>::infinity();
  return speed > 0.0 ? (width - at) / speed : -at / speed;
}

/// Distance from a point in the room to the wall in a direction.
double wallDistance(double x, double y, double angle) {
  return std::min(axisDistance(x, kRoomWidth, std::cos(angle)),
                  axisDistance(y, kRoomHeight, std::sin(angle)));
}

Pose2 truthAt(int step) {
  return {1.5 + 0.05 * step, 1.2 + 0.01 * step, 0.02 * step};
}

class Replay : public testing::Test {
 protected:
  Replay() {
    const Lattice lattice(124, 84, 0.05, {-0.1, -0.1, 0.0});
    std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kFree);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Cell cell = lattice.cell(i);
      const bool is_wall = cell.x < 2 || cell.y < 2 || cell.x > 121 || cell.y > 81;
      if (is_wall) cells[i] = OccupancyGrid::kOccupied;
    }
    saveMap(OccupancyGrid(lattice, cells), folder_.file("room"));
    map_ = folder_.file("room.yaml");
    log_ = folder_.write("drive.clf", driveLog());
    std::vector<StampedPose> truth;
    for (int i = 0; i < kSteps; ++i) truth.push_back({100.0 + 0.2 * i, truthAt(i)});
    truth_ = folder_.file("truth.tum");
    saveTum(truth, truth_);
  }

  static std::string driveLog() {
    std::ostringstream log;
    log.precision(10);
    log << "PARAM robot_frontlaser_offset 0.0 host 0\n";
    for (int i = 0; i < kSteps; ++i) {
      const Pose2 pose = truthAt(i);
      log << "FLASER 180";
      for (int beam = 0; beam < 180; ++beam) {
        const double bearing = (beam - 90) * kPi / 180.0;
        log << ' ' << wallDistance(pose.x, pose.y, pose.theta + bearing);
      }
      const Pose2 odometry = between(truthAt(0), pose);
      for (int k = 0; k < 2; ++k) {
        log << ' ' << odometry.x << ' ' << odometry.y << ' ' << odometry.theta;
      }
      log << ' ' << 100.0 + 0.2 * i << " host 0.0\n";
    }
    return log.str();
  }

  ProgramResult replay(std::vector<std::string> more) const {
    more.insert(more.begin(), {"--map", map_, "--log", log_, "--filter", "kld"});
    return runProgram(REPLAY, more);
  }

  void expectRejected(const std::vector<std::string>& arguments, const std::string& why) const {
    const ProgramResult result = runProgram(REPLAY, arguments);
    EXPECT_EQ(result.exit_code, 1) << why;
    EXPECT_THAT(result.errors, HasSubstr(why));
    EXPECT_THAT(result.output, IsEmpty());
  }

  TempFolder folder_;
  std::string map_, log_, truth_;
};

TEST_F(Replay, FollowsADriveAndWritesAll) {
  const ProgramResult result =
      replay({"--truth", truth_, "--seed", "3", "--json", folder_.file("o.json"), "--trajectory",
              folder_.file("o.tum"), "--plot", folder_.file("o.png")});
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
  EXPECT_THAT(readWhole(folder_.file("o.png")), HasSubstr("PNG"));
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

TEST_F(Replay, RefusesToSearchWithoutReference) {
  const ProgramResult result = replay({"--search", "10"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("--search: no scan has a reference pose"));
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

TEST_F(Replay, WarnsOfUnknownParametersAndBrokenLines) {
  const std::string log = folder_.write("broken.clf", driveLog() + "FLASER 3 1.0\n");
  const ProgramResult result = runProgram(
      REPLAY, {"--map", map_, "--log", log, "--truth", truth_, "--set", "lazer_max_beams=30"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("unknown parameter 'lazer_max_beams'"),
                                   HasSubstr("line 42: ends before 'range'; skipped")));
}

TEST_F(Replay, KnowsItsOwnParameters) {
  const ProgramResult result =
      replay({"--truth", truth_, "--set", "initial_cov_xx=0.01", "odom_frame_id=odom"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, Not(HasSubstr("unknown")));
}

TEST_F(Replay, RejectsWithUsageWhatItDoesNotUnderstand) {
  expectRejected({}, "usage: replay");
  expectRejected({"--map", map_, "--log", log_, "--sped", "1"}, "unknown argument '--sped'");
  expectRejected({"--map", map_, "--log", log_, "--seed", "x"}, "--seed: got 'x'");
}

TEST_F(Replay, RejectsBadInputNamingIt) {
  const auto with = [this](std::vector<std::string> more) {
    more.insert(more.begin(), {"--map", map_, "--log", log_});
    return more;
  };
  expectRejected({"--map", "/does/not/exist.yaml", "--log", log_}, "/does/not/exist.yaml");
  expectRejected({"--map", map_, "--log", "/does/not/exist.bag"}, "/does/not/exist.bag");
  expectRejected({"--map", map_, "--log", folder_.write("text.bag", "text")}, "text.bag");
  expectRejected({"--map", map_, "--log", folder_.write("no.clf", "text")}, "no usable laser scan");
  expectRejected(with({"--filter", "magic"}), "magic");
  expectRejected(with({"--threads", "0"}), "option 'threads'");
  expectRejected(with({"--set", "laser_max_beams=1"}), "option 'laser_max_beams'");
  expectRejected(with({"--start", "truth"}), "no reference");
  expectRejected(with({"--start", "1,2"}), "--start: got '1,2'");
  expectRejected(with({"--truth", "/does/not/exist.tum"}), "/does/not/exist.tum");
  expectRejected(with({"--truth-topic", "/truth"}), "a CARMEN log has no topics");
  expectRejected(with({"--begin", "500"}), "no usable laser scan between the stamps 500");
  expectRejected(with({"--json", "/does/not/exist.json"}), "/does/not/exist.json");
}

TEST_F(Replay, HelpsOnStandardOutput) {
  const ProgramResult result = runProgram(REPLAY, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("usage: replay --map MAP.yaml --log FILE"));
}

}  // namespace
}  // namespace adaptive_localization
