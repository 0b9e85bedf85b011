// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/experiment_result.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

ExperimentResult someResult() {
  ExperimentResult result;
  result.id = {"kidnap", "maze, \"carried\"\n", "sa_kld", 3, "00ff"};
  result.filter = "sa_kld";
  result.status = {{"tracking", 7}, {"lost", 1}};
  result.rms_m = 0.1;
  result.both_share = 1.0 / 3.0;
  result.probe_errors_m = {0.25, 1e-9};
  Trial found;
  found.kind = Trial::Kind::kKidnap;
  found.T_map_base = {1.0, -2.0, 3.0};
  found.found_s = 0.3;
  found.within_s = 1.0;
  found.late_tracking = 2;
  found.left_s = 7.5;
  Trial failed;
  failed.end_status = "tracking";
  failed.is_silent_failure = true;
  result.trials = {found, failed};
  result.calibration.note(0.95, 0.1);
  result.accuracy.mean_m = 0.008;
  result.accuracy.normalized = {std::nullopt, 2.5};
  result.accuracy.drive_bound_m = 0.002;
  return result;
}

TEST(ExperimentResult, IsOneLineThatIsReadBackAsItWas) {
  const std::string line = toLine(someResult());
  EXPECT_THAT(line, testing::Not(HasSubstr("\n")));
  const ExperimentResult back = fromLine(line);
  EXPECT_EQ(toLine(back), line);
  EXPECT_EQ(back.id.of_case, "maze, \"carried\"\n");
  EXPECT_EQ(back.both_share, 1.0 / 3.0);
  EXPECT_EQ(back.status.at("tracking"), 7);
  ASSERT_EQ(back.trials.size(), 2U);
  EXPECT_EQ(back.trials[0].kind, Trial::Kind::kKidnap);
  EXPECT_EQ(back.trials[0].found_s, 0.3);
  EXPECT_EQ(back.trials[0].told_s, std::nullopt);
  EXPECT_EQ(back.trials[0].within_s, 1.0);
  EXPECT_EQ(back.trials[0].late_tracking, 2);
  EXPECT_EQ(back.trials[0].left_s, 7.5);
  EXPECT_EQ(back.trials[1].left_s, std::nullopt);
  EXPECT_EQ(back.calibration.near.at(9), 1);
  EXPECT_EQ(back.accuracy.mean_m, 0.008);
  EXPECT_EQ(back.accuracy.normalized.at(0), std::nullopt);
  EXPECT_EQ(back.accuracy.normalized.at(1), 2.5);
  EXPECT_EQ(back.accuracy.drive_bound_m, 0.002);
  EXPECT_EQ(back.accuracy.scan_bound_m, std::nullopt);
  EXPECT_TRUE(back.trials[1].is_silent_failure);
}

TEST(ExperimentResult, IsNotReadFromAnythingElse) {
  const std::string line = toLine(someResult());
  for (std::size_t length = 0; length < line.size(); length += 7) {
    EXPECT_THROW(fromLine(line.substr(0, length)), std::invalid_argument);
  }
  EXPECT_THROW(fromLine("{}"), std::invalid_argument);
  EXPECT_THROW(fromLine("[1, 2]"), std::invalid_argument);
  std::string other = line;
  other.replace(other.find("\"kind\":\"kidnap\"") + 7, 8, "\"kidnip\"");
  EXPECT_THROW(fromLine(other), std::invalid_argument);
}

}  // namespace
}  // namespace adaptive_localization
