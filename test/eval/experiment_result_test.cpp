// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_result.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
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

TEST(ExperimentResult, IsOneLineOfJson) {
  const std::string line = toLine(someResult());
  EXPECT_THAT(line, testing::Not(HasSubstr("\n")));
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json.at("case"), "maze, \"carried\"\n");
  EXPECT_EQ(json.at("both_share"), 1.0 / 3.0);
  EXPECT_EQ(json.at("status").at("tracking"), 7);
  const auto& trials = json.at("trials");
  ASSERT_EQ(trials.size(), 2U);
  EXPECT_EQ(trials[0].at("kind"), "kidnap");
  EXPECT_EQ(trials[0].at("pose"), nlohmann::json({1.0, -2.0, 3.0}));
  EXPECT_EQ(trials[0].at("found_s"), 0.3);
  EXPECT_TRUE(trials[0].at("told_s").is_null());
  EXPECT_EQ(trials[0].at("within_s"), 1.0);
  EXPECT_EQ(trials[0].at("late_tracking"), 2);
  EXPECT_EQ(trials[0].at("left_s"), 7.5);
  EXPECT_TRUE(trials[1].at("left_s").is_null());
  EXPECT_EQ(trials[1].at("is_silent_failure"), true);
  EXPECT_EQ(json.at("calibration").at("near").at(9), 1);
  const auto& accuracy = json.at("accuracy");
  EXPECT_EQ(accuracy.at("mean_m"), 0.008);
  EXPECT_EQ(accuracy.at("normalized"), nlohmann::json({nullptr, 2.5}));
  EXPECT_EQ(accuracy.at("drive_bound_m"), 0.002);
  EXPECT_TRUE(accuracy.at("scan_bound_m").is_null());
}

TEST(ExperimentResult, TellsWhichRunItWas) {
  const RunId id = idOf(toLine(someResult()));
  EXPECT_EQ(id.name(), someResult().id.name());
  EXPECT_EQ(id.seed, 3);
  EXPECT_EQ(id.settings, "00ff");
}

TEST(ExperimentResult, IsNotReadFromAnythingElse) {
  const std::string line = toLine(someResult());
  for (std::size_t length = 0; length < line.size(); length += 7) {
    EXPECT_THROW(idOf(line.substr(0, length)), std::invalid_argument);
  }
  EXPECT_THROW(idOf("{}"), std::invalid_argument);
  EXPECT_THROW(idOf("[1, 2]"), std::invalid_argument);
}

}  // namespace
}  // namespace adaptive_localization
