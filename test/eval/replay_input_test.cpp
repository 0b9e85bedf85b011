// SPDX-License-Identifier: BSD-3-Clause
// What the executable says to input that is wrong or odd.
#include "toy_replay.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ReplayInput : public Replay {};

TEST_F(ReplayInput, RefusesToSearchWithoutReference) {
  const ProgramResult result = replay({"--search", "10"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("--search: no scan has a reference pose"));
}

TEST_F(ReplayInput, WarnsOfUnknownParametersAndBrokenLines) {
  const std::string log = folder_.write("broken.clf", driveLog() + "FLASER 3 1.0\n");
  const ProgramResult result = runProgram(
      REPLAY, {"--map", map_, "--log", log, "--truth", truth_, "--set", "lazer_max_beams=30"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("unknown parameter 'lazer_max_beams'; did you mean "
                                             "'laser_max_beams'?"),
                                   HasSubstr("line 42: ends before 'range'; skipped")));
}

TEST_F(ReplayInput, KnowsItsOwnParameters) {
  const ProgramResult result =
      replay({"--truth", truth_, "--set", "initial_cov_xx=0.01", "odom_frame_id=odom"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, Not(HasSubstr("unknown")));
}

TEST_F(ReplayInput, TakesParameterFilesOfTheNodeAndOfAmcl) {
  const std::string node = folder_.write(
      "node.yaml", "odom_frame_id: odom\nglobal_frame_id: map\ntf_rate: 20\nfilter: kld\n");
  const ProgramResult result =
      replay({"--truth", truth_, "--params", SOURCE_DIR "/config/amcl.yaml", node});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, Not(HasSubstr("unknown")));
  EXPECT_THAT(result.errors, AllOf(HasSubstr("no effect here:"), HasSubstr(" global_frame_id"),
                                   HasSubstr(" tf_rate"), HasSubstr(" gui_publish_rate")));
  EXPECT_THAT(result.errors, Not(HasSubstr(" odom_frame_id")));
}

TEST_F(ReplayInput, EndsBadlyOnAnotherMapUnlessToldOtherwise) {
  const std::string corridor = saveRoom("corridor", 204, 20);
  for (const char* start : {"global", "1.5,0.4,0"}) {
    std::vector<std::string> arguments{"--map", corridor, "--log", log_, "--start", start};
    const ProgramResult refused = runProgram(REPLAY, arguments);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("the scans do not fit the map '" + corridor + "'"),
                                      HasSubstr("--allow-misfit")));
    EXPECT_THAT(refused.output, HasSubstr("40 scans")) << "the numbers are there all the same";
    arguments.push_back("--allow-misfit");
    const ProgramResult allowed = runProgram(REPLAY, arguments);
    EXPECT_EQ(allowed.exit_code, 0);
    EXPECT_THAT(allowed.errors, IsEmpty());
  }
}

TEST_F(ReplayInput, RejectsWithUsageWhatItDoesNotUnderstand) {
  expectRejected({}, "usage: replay");
  expectRejected({"--map", map_, "--log", log_, "--sped", "1"}, "unknown argument '--sped'");
  expectRejected({"--map", map_, "--log", log_, "--sped", "1"}, "did you mean '--seed'?");
  expectRejected({"--map", map_, "--log", log_, "--seed", "x"}, "--seed: got 'x'");
}

TEST_F(ReplayInput, RejectsBadInputNamingIt) {
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
  expectRejected(with({"--start", "50,2,0"}), "--start: got a pose at (50.000, 2.000) m");
  expectRejected({"--map", folder_.file("room.pgm"), "--log", log_}, "expected a YAML file");
  expectRejected(with({"--truth", "/does/not/exist.tum"}), "/does/not/exist.tum");
  expectRejected(with({"--truth-topic", "/truth"}), "a CARMEN log has no topics");
  expectRejected(with({"--begin", "500"}), "no usable laser scan between the stamps 500");
  expectRejected(with({"--json", "/does/not/exist.json"}), "/does/not/exist.json");
}

}  // namespace
}  // namespace adaptive_localization
