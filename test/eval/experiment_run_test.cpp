// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "eval/experiment_loader.hpp"

namespace adaptive_localization {

/// People walk beside the robot in a narrow maze: for 20 of each 25 s a third of the laser sees
/// them and not the corridor's end. These seeds once slid along the corridor and said tracking, 1 m
/// off.
TEST(ExperimentRun, ARobotWithAThirdOfItsLaserBlockedKeepsItsPlace) {
  const Experiment experiment = loadExperiment(SOURCE_DIR "/config/experiments/false_alarms.yaml");
  for (const ExperimentCase& of_case : experiment.cases) {
    if (of_case.label != "maze, side by side") continue;
    const ExperimentSite site = loadSite(of_case);
    for (const ExperimentCore& core : of_case.cores) {
      if (core.label != "sa_kld") continue;
      for (const int seed : {17, 24}) {
        const ExperimentResult result = runExperiment(site, of_case, core, seed);
        EXPECT_EQ(result.silently_wrong, 0) << seed;
        EXPECT_LT(result.max_m, 0.25) << seed;
        EXPECT_GT(result.scans, 1000) << seed;
      }
      return;
    }
  }
  FAIL() << "no such case";
}

/// In a hall that looks the same after half a turn; without reflectors nobody says tracking there.
TEST(ExperimentRun, ARobotThatSeesReflectorsKnowsWhichEndOfTheHallItIsIn) {
  for (const bool are_seen : {true, false}) {
    const Experiment experiment =
        loadExperiment(SOURCE_DIR "/config/experiments/reflectors.yaml",
                       {{"reflector_intensity", are_seen ? "120" : "0"}, {"duration", "20"}});
    const ExperimentCase& of_case = experiment.cases.front();
    const auto core = std::find_if(of_case.cores.begin(), of_case.cores.end(),
                                   [](const auto& one) { return one.label == "sa_kld"; });
    ASSERT_NE(core, of_case.cores.end());
    const ExperimentSite site = loadSite(of_case);
    for (const int seed : {1, 2, 3}) {
      const ExperimentResult result = runExperiment(site, of_case, *core, seed);
      const auto word = result.status.find("tracking");
      const int tracking = word == result.status.end() ? 0 : word->second;
      EXPECT_EQ(result.silently_wrong, 0) << seed;
      if (are_seen) {
        EXPECT_GT(tracking, result.scans / 2) << seed;
        EXPECT_LT(result.trials.at(0).found_s.value_or(100.0), 10.0) << seed;
      } else {
        EXPECT_EQ(tracking, 0) << seed;
      }
    }
  }
}

}  // namespace adaptive_localization
