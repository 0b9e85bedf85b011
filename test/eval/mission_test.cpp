// SPDX-License-Identifier: BSD-3-Clause
// A robot that steers by its estimate, and how far off it is on the floor.
#include <gmock/gmock.h>

#include "eval/experiment_run.hpp"
#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

ExperimentResult driveMission(const Overrides& overrides = {}) {
  const ToyExperiment toy;
  const Experiment experiment = toy.load(
      "start: random\nstart_known: true\nduration: 60\n"
      "simulation: {drive_by: estimate, route_arrival: 0.03, route_brakes: true}\n",
      overrides);
  const ExperimentCase& of_case = experiment.cases.front();
  return runExperiment(loadSite(of_case), of_case, of_case.cores.front(), 3);
}

TEST(Mission, IsDrivenByTheEstimateAndItsErrorsAreThoseOnTheFloor) {
  const ExperimentResult result = driveMission();
  ASSERT_GE(result.arrival_errors_m.size(), 4U);
  EXPECT_LT(result.rms_m, 0.05);
  for (const double error : result.arrival_errors_m) {
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 0.03 + 0.10);  // of the driver, and of the estimate
  }
  EXPECT_GT(result.way_error_m, 0.0);
  EXPECT_LT(result.way_error_m, 0.15);
}

TEST(Mission, IsNotTheOneOfADriverWhoKnowsTheTruth) {
  const ExperimentResult result = driveMission({{"simulation.drive_by", "truth"}});
  EXPECT_TRUE(result.arrival_errors_m.empty());
  EXPECT_EQ(result.way_error_m, 0.0);
}

}  // namespace
}  // namespace adaptive_localization
