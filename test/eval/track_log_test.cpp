// SPDX-License-Identifier: BSD-3-Clause
// test/examples/01_track_log.cpp, as somebody runs it who wants to localize in a program of their
// own.
#include <gmock/gmock.h>

#include <sstream>

#include "toy_replay.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

class TrackLog : public Replay {
 protected:
  ProgramResult track(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {map_, log_, "1.5", "1.2", "0"});
    return runProgram(TRACK_LOG, more);
  }
};

TEST_F(TrackLog, FollowsTheRobot) {
  const ProgramResult result = track({"seed=2"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::istringstream lines(result.output);
  int count = 0;
  double stamp = 0.0, confidence = 0.0;
  Pose2 pose;
  std::string status;
  while (lines >> stamp >> pose.x >> pose.y >> pose.theta >> status >> confidence) {
    EXPECT_LT(distance(pose, truthAt(count)), 0.1) << "scan " << count;
    ++count;
  }
  EXPECT_EQ(count, kSteps);
  EXPECT_EQ(status, "ambiguous") << "the room looks the same after half a turn";
  EXPECT_GT(confidence, 0.7);
  EXPECT_LE(confidence, 0.8) << "somebody may have told the wrong one of two";
}

TEST_F(TrackLog, SaysWhatIsWrong) {
  const auto expect = [](const ProgramResult& result, const std::string& why) {
    EXPECT_EQ(result.exit_code, 1) << why;
    EXPECT_THAT(result.errors, HasSubstr(why));
  };
  expect(track({"seed"}), "got 'seed', expected KEY=VALUE");
  expect(track({"sead=2"}), "option 'sead' is unknown");
  expect(track({"seed=-2"}), "'seed': got '-2'");
  expect(runProgram(TRACK_LOG, {map_, "nosuch.clf", "1", "1", "0"}), "log 'nosuch.clf'");
  expect(runProgram(TRACK_LOG, {"nosuch.yaml", log_, "1", "1", "0"}), "nosuch.yaml");
  expect(runProgram(TRACK_LOG, {map_}), "usage: 01_track_log");
}

}  // namespace
}  // namespace adaptive_localization
