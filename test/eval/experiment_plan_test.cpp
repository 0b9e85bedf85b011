// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_plan.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <stdexcept>

#include "eval/experiment_file.hpp"
#include "support/program.hpp"
#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

std::set<std::string> names(const std::vector<PlannedRun>& runs) {
  std::set<std::string> all;
  for (const auto& run : runs) {
    const RunId id = run.id();
    all.insert(id.of_case + "/" + id.label + "/" + std::to_string(id.seed));
  }
  return all;
}

class Plan : public testing::Test {
 protected:
  Plan()
      : experiments_{loadExperiment(toy_.write(
            "duration: 1\nseeds: {first: 5, count: 3}\ncases: [{label: a}, {label: b}]\n"
            "cores: [{filter: mcl, options: {max_particles: 100}}, {filter: kld}]\n"))} {}

  ToyExperiment toy_;
  std::vector<Experiment> experiments_;
};

TEST_F(Plan, HasEveryRunOnce) {
  const auto runs = planRuns(experiments_, {}, {});
  EXPECT_THAT(runs, SizeIs(12));
  EXPECT_THAT(names(runs), SizeIs(12));
  EXPECT_EQ(names(runs).count("b/kld/7"), 1U);
  EXPECT_THAT(names(planRuns(experiments_, {}, {"b/kld", "a/mcl"})), SizeIs(6));
}

TEST_F(Plan, IsCutIntoShardsThatHaveAllRunsTogetherAndNoneTwice) {
  for (const std::size_t count : {1U, 2U, 5U, 20U}) {
    std::set<std::string> all;
    std::size_t sum = 0;
    for (std::size_t i = 1; i <= count; ++i) {
      const auto part = names(planRuns(experiments_, {i, count}, {}));
      all.insert(part.begin(), part.end());
      sum += part.size();
    }
    EXPECT_EQ(sum, 12U) << count;
    EXPECT_THAT(all, SizeIs(12)) << count;
  }
}

TEST_F(Plan, TellsRunsWithOtherSettingsApart) {
  const auto runs = planRuns(experiments_, {}, {});
  EXPECT_NE(runs[0].id().settings, runs[3].id().settings);
  EXPECT_EQ(runs[0].id().settings, runs[1].id().settings);
}

TEST_F(Plan, IsStoppedByARunThatFails) {
  experiments_[0].cases[1].start.regions = {{{100.0, 100.0}, {101.0, 101.0}}};
  std::atomic<int> taken{0};
  EXPECT_THAT(
      [&] { makeRuns(planRuns(experiments_, {}, {"b/mcl"}), 2, [&](const auto&) { ++taken; }); },
      ThrowsMessage<std::runtime_error>(HasSubstr("toy/b/mcl, seed")));
  EXPECT_EQ(taken, 0);
}

TEST_F(Plan, IsRefusedForACoreThatCannotBeMade) {
  experiments_[0].cases[0].cores[0].parameters.set("max_particles", OptionValue(-3));
  EXPECT_THAT([&] { makeRuns(planRuns(experiments_, {}, {}), 1, [](const auto&) {}); },
              ThrowsMessage<std::invalid_argument>(
                  testing::AllOf(HasSubstr("core 'mcl'"), HasSubstr("'max_particles'"))));
}

class Results : public Plan {
 protected:
  Results() : file_(toy_.folder().file("results.jsonl")) {}

  /// Makes what the file does not have yet.
  std::size_t goOn(int jobs) {
    ExperimentFile file(file_);
    const auto missing = file.missing(planRuns(experiments_, {}, {"a/mcl"}));
    makeRuns(missing, jobs, [&](const ExperimentResult& result) { file.add(result); });
    return missing.size();
  }

  std::string file_;
};

TEST_F(Results, AreGoneOnWithAfterTheLastWasCutOff) {
  EXPECT_EQ(goOn(1), 3U);
  EXPECT_EQ(goOn(1), 0U);
  const std::string whole = readWhole(file_);
  for (const std::size_t cut : {1U, 30U}) {
    toy_.folder().write("results.jsonl", whole.substr(0, whole.size() - cut));
    EXPECT_EQ(ExperimentFile(file_).size(), 2U);
    EXPECT_EQ(goOn(2), 1U);
    EXPECT_EQ(ExperimentFile(file_).size(), 3U);
    EXPECT_EQ(goOn(1), 0U);
  }
}

TEST_F(Results, OfOtherSettingsAreNotMixed) {
  goOn(1);
  experiments_[0].cases[0].cores[0].parameters.set("max_particles", OptionValue(200));
  EXPECT_THAT([&] { goOn(1); }, ThrowsMessage<std::invalid_argument>(
                                    testing::AllOf(HasSubstr(file_), HasSubstr("other settings"))));
}

TEST_F(Results, ThatAreNoneAreRefused) {
  toy_.folder().write("results.jsonl", "this is\nno result\n");
  EXPECT_THAT([&] { goOn(1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("results.jsonl', line 1")));
  EXPECT_THAT([&] { ExperimentFile(toy_.folder().file("no/such/folder")); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("cannot be written")));
}

}  // namespace
}  // namespace adaptive_localization
