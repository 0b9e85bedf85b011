// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report.hpp"

#include <gmock/gmock.h>

#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

/// A step whose estimate is off by `error` metres.
RunStep step(double stamp, double error) {
  RunStep result;
  result.stamp = stamp;
  result.T_map_base_reference = Pose2{stamp, 5.0, 3.0};
  result.T_map_base = {stamp, 5.0 + error, 3.0};
  return result;
}

TEST(Report, HoldsTheAgreedKeys) {
  RunRecord run;
  run.steps = {step(0, 0.1), step(1, 0.1)};
  const auto json = toJson({"a.bag", "m.yaml", "kld", 7, 2}, measure(run));
  for (const char* key : {"filter",         "seed",
                          "threads",        "scans",
                          "updates",        "duration_s",
                          "path_m",         "wall_s",
                          "cpu_s",          "peak_rss_mb",
                          "update_ms",      "particles",
                          "ate_rmse_m",     "update_cpu_ms",
                          "ate_mean_m",     "nees",
                          "ate_median_m",   "ate_p95_m",
                          "ate_max_m",      "heading_rmse_deg",
                          "final_error_m",  "final_heading_error_deg",
                          "converged_at_s", "lost_share",
                          "misled_share",   "confidence_mean",
                          "start",          "tracking_share",
                          "nowhere_share",  "misled_longest_s",
                          "jumps",          "spoil",
                          "spoil_seed",     "calibration",
                          "carried"}) {
    ASSERT_TRUE(json.contains(key)) << key;
    EXPECT_FALSE(json[key].is_null()) << key;
  }
  for (const char* key : {"median", "p99", "max"}) EXPECT_TRUE(json["update_ms"].contains(key));
  for (const char* key : {"mean", "max"}) EXPECT_TRUE(json["particles"].contains(key));
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["filter"], "kld");
}

TEST(Report, ErrorsAreNullWithoutReference) {
  RunRecord run;
  run.steps = {step(0, 0.1)};
  run.steps[0].T_map_base_reference.reset();
  const auto json = toJson({"a.bag", "m.yaml", "kld", 1, 1}, measure(run));
  for (const char* key : {"ate_rmse_m", "final_error_m", "converged_at_s", "lost_share"}) {
    EXPECT_TRUE(json.at(key).is_null()) << key;
  }
  EXPECT_THAT(summarize({"a.bag", "m.yaml", "kld", 1, 1}, measure(run)), HasSubstr("no reference"));
}

TEST(Report, NeverConvergedIsNull) {
  RunRecord run;
  run.steps = {step(0, 9.0)};
  const auto json = toJson({"a.bag", "m.yaml", "kld", 1, 1}, measure(run));
  EXPECT_TRUE(json.at("converged_at_s").is_null());
  EXPECT_DOUBLE_EQ(json.at("lost_share").get<double>(), 1.0);
}

TEST(Report, SurvivesNamesThatAreNoUnicode) {
  const TempFolder folder;
  saveJson(toJson({"\xff.bag", "m.yaml", "kld", 1, 1}, Metrics{}), folder.file("a.json"));
  std::ifstream input(folder.file("a.json"));
  EXPECT_EQ(nlohmann::json::parse(input).at("filter"), "kld");
}

TEST(Report, SaysWhichFileCannotBeWritten) {
  EXPECT_THAT([] { saveJson({}, "/does/not/exist.json"); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("'/does/not/exist.json'")));
}

}  // namespace
}  // namespace adaptive_localization
