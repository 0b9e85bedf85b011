// SPDX-License-Identifier: BSD-3-Clause
// What matching brings to the cores, on a drive through the maze as the experiments have it: with
// scans of the plan and a map that is not aligned with it.
#include <gtest/gtest.h>

#include <algorithm>

#include "eval/experiment_loader.hpp"
#include "eval/experiment_run.hpp"

namespace adaptive_localization {
namespace {

double errorOf(const std::string& core) {
  const Experiment experiment =
      loadExperiment(SOURCE_DIR "/config/experiments/ekf_accuracy.yaml", {{"duration", "30"}});
  const auto surveyed = std::find_if(experiment.cases.begin(), experiment.cases.end(),
                                     [](const ExperimentCase& each) { return each.map.empty(); });
  if (surveyed == experiment.cases.end()) throw std::runtime_error("no surveyed map");
  const auto named = std::find_if(surveyed->cores.begin(), surveyed->cores.end(),
                                  [&](const ExperimentCore& each) { return each.label == core; });
  if (named == surveyed->cores.end()) throw std::runtime_error("no core " + core);
  return runExperiment(loadSite(*surveyed), *surveyed, *named, 1).rms_m;
}

TEST(RefinedCores, AreWithinFiveMillimetresInTheMaze) {
  EXPECT_LT(errorOf("ekf_icp"), 0.005);
  EXPECT_LT(errorOf("kld refined"), 0.005);
  EXPECT_LT(errorOf("sa_kld refined"), 0.005);
  EXPECT_GT(errorOf("kld"), 0.010) << "not refined";
}

}  // namespace
}  // namespace adaptive_localization
