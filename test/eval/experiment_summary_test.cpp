// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/experiment_summary.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "adaptive_localization/eval/experiment_plot.hpp"
#include "support/program.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A run with one start that was not known, found after so many seconds, or never.
ExperimentResult runWith(const std::string& label, int seed, std::optional<double> found_s) {
  ExperimentResult result;
  result.id = {"toy", "hall", label, seed, "same"};
  result.filter = "kld";
  result.scans = 100;
  result.settled_s = found_s ? 36.0 : 0.0;
  result.status = {{"tracking", 25}, {"globalizing", 75}};
  result.particles_max = 10 * seed;
  Trial trial;
  trial.found_s = trial.told_s = found_s;
  trial.end_error_m = found_s ? 0.1 : 3.0;
  trial.is_silent_failure = !found_s;
  trial.searching_tracking = found_s ? 0 : 2;
  result.trials = {trial};
  return result;
}

/// Ten runs, found after 1, 2, ... 9 s and never.
std::vector<ExperimentResult> tenRuns(const std::string& label) {
  std::vector<ExperimentResult> runs;
  for (int seed = 1; seed <= 10; ++seed) {
    runs.push_back(runWith(label, seed, seed < 10 ? std::optional<double>(seed) : std::nullopt));
  }
  return runs;
}

std::string json(const std::vector<ExperimentSummary>& rows) {
  std::string text;
  for (const auto& row : rows) text += toJson(row).dump();
  return text;
}

TEST(ExperimentSummary, CountsAndTakesQuantiles) {
  const auto rows = summarize(tenRuns("kld"));
  ASSERT_EQ(rows.size(), 1U);
  const ExperimentSummary& row = rows.front();
  EXPECT_EQ(row.runs, 10);
  EXPECT_EQ(row.found.count, 9);
  EXPECT_EQ(row.found.of, 10);
  EXPECT_EQ(row.found_median_s, 5.0);
  EXPECT_EQ(row.found_p95_s, std::nullopt) << "a tenth was never found";
  EXPECT_EQ(row.found_s.size(), 9U);
  EXPECT_EQ(row.right_at_end.count, 9);
  EXPECT_EQ(row.silent_failures.count, 1);
  EXPECT_EQ(row.flagged.count, 9);
  EXPECT_DOUBLE_EQ(row.settled_h, 0.09);
  EXPECT_DOUBLE_EQ(row.tracking_share, 0.25);
  EXPECT_EQ(row.particles_max, 100);
}

TEST(ExperimentSummary, TellsTrialsThatWereAmbiguousApart) {
  auto runs = tenRuns("kld");
  for (auto& run : runs) run.trials.front().searching_ambiguous = run.id.seed > 4;
  const ExperimentSummary row = summarize(runs).front();
  EXPECT_EQ(row.ambiguous.count, 6);
  EXPECT_EQ(row.clear_median_s, 2.0);
  EXPECT_EQ(row.clear_p95_s, 4.0);
  EXPECT_THAT(toTables({row}), HasSubstr("| 6/10 | 2.0, 4.0 |"));
}

TEST(ExperimentSummary, LeavesOutStartsThatWereKnown) {
  ExperimentResult run = runWith("kld", 1, 0.0);
  run.trials.front().kind = Trial::Kind::kKnownStart;
  EXPECT_EQ(summarize({run}).front().found.of, 0);
  const std::string table = toTables(summarize({run}));
  EXPECT_THAT(table, Not(HasSubstr("found")));
  EXPECT_THAT(table, HasSubstr("| hall | kld | 1 |"));
}

TEST(ExperimentSummary, CountsKnownStartsThatWereLeft) {
  auto runs = tenRuns("kld");
  for (auto& run : runs) {
    run.trials.front().left_s = 1.0;  // a start that was found
    Trial known;
    known.kind = Trial::Kind::kKnownStart;
    if (run.id.seed > 8) known.left_s = 3.0;
    run.trials.push_back(known);
  }
  const ExperimentSummary row = summarize(runs).front();
  EXPECT_EQ(row.left.count, 2);
  EXPECT_EQ(row.left.of, 10);
  EXPECT_EQ(row.found.of, 10);
  EXPECT_EQ(toJson(row).at("left").at("count"), 2);
  EXPECT_THAT(toTables({row}), HasSubstr("left a known start"));
  EXPECT_THAT(toTables(summarize(tenRuns("kld"))), Not(HasSubstr("left a known start")));
}

TEST(ExperimentSummary, AddsUpJumpsAndCalibration) {
  auto runs = tenRuns("kld");
  for (auto& run : runs) {
    run.jumps = run.id.seed == 3 ? 5 : 0;
    run.calibration.note(0.95, run.id.seed == 1 ? 1.0 : 0.1);
    run.calibration.note(0.15, 1.0);
  }
  const ExperimentSummary row = summarize(runs).front();
  EXPECT_DOUBLE_EQ(row.jumps_per_run, 0.5);
  EXPECT_EQ(row.calibration.scans[9], 10);
  EXPECT_EQ(row.calibration.near[9], 9);
  EXPECT_THAT(toTables({row}), HasSubstr("| 0.50 | – 0.00 – – – – – – – 0.90 |"));
  EXPECT_EQ(toJson(row).at("jumps_per_run"), 0.5);
  const auto calibration = toJson(row).at("calibration");
  EXPECT_EQ(calibration.at("scans").at(1), 10);
  EXPECT_TRUE(calibration.at("share").at(0).is_null());
  EXPECT_EQ(calibration.at("share").at(9), 0.9);
}

TEST(ExperimentSummary, TellsHowManyParticlesThereWereAndHowOftenTheyWereDrawnElsewhere) {
  auto runs = tenRuns("kld");
  for (auto& run : runs) {
    run.looks_elsewhere = run.id.seed == 2 ? 5 : 1;
    run.particles_by_s = {5000, 300};
  }
  runs.front().particles_by_s = {1000, 200, 100};  // a longer run
  const ExperimentSummary row = summarize(runs).front();
  EXPECT_THAT(row.particles_by_s, testing::ElementsAre(4600.0, 290.0, 100.0));
  EXPECT_DOUBLE_EQ(row.looks_elsewhere, 1.4);
  EXPECT_THAT(toTables({row}), HasSubstr("looks elsewhere per run"));
  EXPECT_THAT(toTables(summarize(tenRuns("kld"))), Not(HasSubstr("looks elsewhere")));
  EXPECT_EQ(toJson(row).at("particles").at("by_s").size(), 3U);
  EXPECT_EQ(toJson(row).at("looks_elsewhere"), 1.4);
}

TEST(ExperimentSummary, DoesNotDependOnTheOrderOfTheResultsNorOnDoubles) {
  auto runs = tenRuns("kld");
  const auto more = tenRuns("amcl");
  runs.insert(runs.end(), more.begin(), more.end());
  const std::string expected = json(summarize(runs));
  std::reverse(runs.begin(), runs.end());
  runs.push_back(runs[3]);
  EXPECT_EQ(json(summarize(runs)), expected);
  EXPECT_LT(expected.find("amcl"), expected.find("kld"));
}

TEST(ExperimentSummary, OfUnlikeRunsIsRefused) {
  auto runs = tenRuns("kld");
  runs.back().id.settings = "other";
  EXPECT_THAT([&] { summarize(runs); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("toy/hall/kld")));
}

TEST(ExperimentSummary, IsShownAsATableForEachExperiment) {
  auto runs = tenRuns("kld");
  for (auto& run : runs) run.both_share = 0.5;
  runs.push_back(runWith("amcl", 1, 0.25));
  runs.back().id.experiment = "other";
  const std::string tables = toTables(summarize(runs));
  EXPECT_THAT(tables, HasSubstr("other:\n\n| case | core | runs | found |"));
  EXPECT_THAT(tables, HasSubstr("| hall | kld | 10 | 9/10 | 59.6–98.2 % | 5.0, never |"));
  EXPECT_EQ(tables.find("both places"), tables.rfind("both places at the end"))
      << "only one of the two experiments has such places";
}

TEST(ExperimentSummary, IsDrawn) {
  const TempFolder folder;
  savePlot(summarize(tenRuns("kld")), folder.file("o.png"));
  EXPECT_THAT(readWhole(folder.file("o.png")), HasSubstr("PNG"));
  savePlot({}, folder.file("none.png"));
  EXPECT_THAT([&] { savePlot({}, folder.file("o.nosuch")); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("o.nosuch")));
}

TEST(ExperimentSummary, OfNothingIsEmpty) {
  EXPECT_TRUE(summarize({}).empty());
  EXPECT_EQ(toTables({}), "");
}

}  // namespace
}  // namespace adaptive_localization
