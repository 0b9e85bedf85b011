// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/experiment_run.hpp"

#include <gtest/gtest.h>

#include "adaptive_localization/eval/experiment_loader.hpp"

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

}  // namespace adaptive_localization
