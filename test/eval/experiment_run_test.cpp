// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "../../src/eval/experiment_drive.hpp"
#include "eval/experiment_loader.hpp"
#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

template <class All>
const auto& named(const All& all, const std::string& label) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.label == label; });
  if (found == all.end()) throw std::invalid_argument("no '" + label + "'");
  return *found;
}

/// The sa_kld of a case of config/experiments.
struct Arena {
  Arena(const std::string& file, const std::string& label)
      : experiment(loadExperiment(SOURCE_DIR "/config/experiments/" + file)),
        of_case(named(experiment.cases, label)),
        core(named(of_case.cores, "sa_kld")),
        site(loadSite(of_case)) {}

  ExperimentResult run(int seed) const { return runExperiment(site, of_case, core, seed); }

  /// How far the robot is at the most from where odometry alone has it, m.
  double driftOfWheels(int seed) const {
    ExperimentDrive drive(site, of_case, seed);
    const Pose2 start = drive.truth();
    double most = 0.0;
    while (const auto seen = drive.next()) {
      most = std::max(most, distance(start * seen->T_odom_base, drive.truth()));
    }
    return most;
  }

  Experiment experiment;
  const ExperimentCase& of_case;
  const ExperimentCore& core;
  ExperimentSite site;
};

}  // namespace

/// With a scan each two seconds the robot has driven most of a metre before the first. What is told
/// of the start is moved along with it.
TEST(ExperimentRun, ARobotThatIsToldItsStartIsThereAtTheFirstScan) {
  const ToyExperiment toy;
  const Experiment experiment =
      toy.load("start_known: true\nduration: 3\nsimulation: {scan_rate: 0.5}\n");
  const ExperimentCase& of_case = experiment.cases.front();
  const ExperimentSite site = loadSite(of_case);
  for (int seed = 1; seed <= 10; ++seed) {
    const auto result = runExperiment(site, of_case, of_case.cores.front(), seed);
    EXPECT_EQ(result.scans, 1);
    EXPECT_LT(result.max_m, 0.1) << seed;
  }
}

/// People walk beside the robot in a narrow maze: for 20 of each 25 s a third of the laser sees
/// them and not the corridor's end. These seeds once slid along the corridor and said tracking, 1 m
/// off.
TEST(ExperimentRun, ARobotWithAThirdOfItsLaserBlockedKeepsItsPlace) {
  const Arena arena("false_alarms.yaml", "maze, side by side");
  for (const int seed : {17, 24}) {
    const ExperimentResult result = arena.run(seed);
    EXPECT_EQ(result.silently_wrong, 0) << seed;
    EXPECT_LT(result.max_m, 0.25) << seed;
    EXPECT_GT(result.scans, 1000) << seed;
  }
}

/// In the middle of a large building a laser that reaches 3.5 m sees nothing, but for stray hits.
/// With these seeds the status was once "lost" for 81 and 141 of the scans.
TEST(ExperimentRun, AShortSightedRobotIsNotLostInTheOpen) {
  const Arena arena("lasers.yaml", "LDS-01, complex, told");
  for (const int seed : {1, 3}) {
    const ExperimentResult result = arena.run(seed);
    const auto lost = result.status.find("lost");
    EXPECT_LT(lost == result.status.end() ? 0 : lost->second, 5) << seed;
    EXPECT_EQ(result.silently_wrong, 0) << seed;
    EXPECT_LT(result.max_m, 0.5) << seed;
  }
}

/// Nor is one that sees 57 degrees; with seeds 1 and 3 it once was, 35 and 21 m off. With seed 1 it
/// sees hardly a wall for half a minute, in which odometry alone is nearly a metre off.
TEST(ExperimentRun, ARobotWithADepthCameraKeepsThePlaceThatItWasTold) {
  const Arena arena("lasers.yaml", "depth camera, complex, told");
  for (const int seed : {1, 2, 3, 8, 10}) {
    const ExperimentResult result = arena.run(seed);
    EXPECT_EQ(result.silently_wrong, 0) << seed;
    EXPECT_LT(result.max_m, seed == 1 ? 2.0 : 1.0) << seed;
  }
}

/// All aisles look alike. With the first case the pose once left for another one, 12.8 m away; with
/// the second it does, 3.2 m, if places that wheels can have slipped to are no likelier than
/// others.
TEST(ExperimentRun, ARobotWhoseWheelsSlipInAnAisleStaysInIt) {
  for (const auto& [label, seed] :
       {std::pair("LDS-01, slips, warehouse", 2), {"LDS-01, slips much, warehouse", 5}}) {
    const Arena arena("slips.yaml", label);
    ASSERT_GT(arena.driftOfWheels(seed), 1.0) << "or the wheels did not slip: " << label;
    const ExperimentResult result = arena.run(seed);
    EXPECT_EQ(result.silently_wrong, 0) << label;
    EXPECT_LT(result.max_m, 1.0) << label;
  }
}

/// Where wheels slip by up to a radian for some scans on end, and what odometry has of it fits
/// nowhere near: with these seeds a core that was right was taken elsewhere, up to 32 m, or the
/// pose rode on the odometry, or on the place that was known, up to 9 m.
TEST(ExperimentRun, ARobotWhoseWheelsSlipOnEndIsWhereItsCoreHasIt) {
  for (const auto& [label, seed] : {std::pair("LDS-01, slips much, office", 12),
                                    {"8 m, slips much, office", 10},
                                    {"8 m, slips much, corridor", 2},
                                    {"8 m, slips much, hall", 2},
                                    {"8 m, slips much, hall", 3}}) {
    const ExperimentResult result = Arena("slips.yaml", label).run(seed);
    EXPECT_LT(result.max_m, 0.5) << label;
    EXPECT_LT(result.silently_wrong, 5) << label;
  }
}

/// In a hall that looks the same after half a turn; without reflectors nobody says tracking there.
TEST(ExperimentRun, ARobotThatSeesReflectorsKnowsWhichEndOfTheHallItIsIn) {
  for (const bool are_seen : {true, false}) {
    const Experiment experiment =
        loadExperiment(SOURCE_DIR "/config/experiments/reflectors.yaml",
                       {{"reflector_intensity", are_seen ? "120" : "0"}, {"duration", "20"}});
    const ExperimentCase& of_case = experiment.cases.front();
    const ExperimentCore& core = named(of_case.cores, "sa_kld");
    const ExperimentSite site = loadSite(of_case);
    for (const int seed : {1, 2, 3}) {
      const ExperimentResult result = runExperiment(site, of_case, core, seed);
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
