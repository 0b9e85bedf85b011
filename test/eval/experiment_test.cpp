// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <filesystem>

#include "adaptive_localization/core/rng.hpp"
#include "eval/experiment_loader.hpp"
#include "eval/experiment_plan.hpp"
#include "eval/experiment_run.hpp"
#include "support/program.hpp"
#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;
using What = ExperimentEvent::What;

class ExperimentYaml : public testing::Test {
 protected:
  /// What is said about a file with these lines beside the required ones.
  void expectRejected(const std::string& lines, const std::string& why) const {
    expectRejectedFile(toy_.write(ToyExperiment::cores() + lines), why);
  }
  static void expectRejectedFile(const std::string& file, const std::string& why) {
    EXPECT_THAT([&] { loadExperiment(file); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(file), HasSubstr(why))));
  }

  ToyExperiment toy_;
};

TEST_F(ExperimentYaml, HasDefaultsForAllButWhatMatters) {
  const Experiment experiment = toy_.load("");
  EXPECT_EQ(experiment.name, "toy");
  ASSERT_THAT(experiment.cases, SizeIs(1));
  const ExperimentCase& only = experiment.cases.front();
  EXPECT_EQ(only.experiment, "toy");
  EXPECT_THAT(only.map, testing::EndsWith("map.yaml"));
  EXPECT_FALSE(only.is_start_known);
  EXPECT_FALSE(only.start.pose);
  EXPECT_THAT(only.events, SizeIs(0));
  EXPECT_DOUBLE_EQ(only.success.position, 0.15);
  EXPECT_DOUBLE_EQ(only.success.heading, 5.0 * kPi / 180.0);
  EXPECT_EQ(only.success.scans, 3);
  ASSERT_THAT(only.cores, SizeIs(1));
  EXPECT_EQ(only.cores.front().label, "kld");
  EXPECT_TRUE(SimulationOptions::from(only.simulation).drive);
}

TEST_F(ExperimentYaml, IsReadInFull) {
  const Experiment experiment = toy_.load(
      "route: [[1, 1], [3, 2]]\nstart: [1, 1, 0.5]\nstart_known: true\nduration: 9\n"
      "simulation: {people: 2, drive: false}\nprobes: [1, 2]\nhalf_turn: [3, 2]\n"
      "success: {position: 0.3, heading: 10, scans: 2}\nseeds: {first: 7, count: 3}\n"
      "options: {update_min_d: 0, max_particles: 9}\n"
      "events:\n"
      "  - {what: kidnap, at: 2, every: 3, to: {regions: [[2, 1, 0, 0]], yaw: [1, 0], "
      "farther_than: 2}}\n"
      "  - {what: carry, at: 4, for: 2, laser: garbage}\n"
      "  - {what: block, at: 5, for: 3, share: 0.25, pattern: sector}\n");
  const ExperimentCase& only = experiment.cases.front();
  ASSERT_TRUE(only.route);
  EXPECT_THAT(*only.route, SizeIs(2));
  ASSERT_TRUE(only.start.pose);
  EXPECT_DOUBLE_EQ(only.start.pose->theta, 0.5);
  EXPECT_TRUE(only.is_start_known);
  EXPECT_DOUBLE_EQ(only.duration, 9.0);
  EXPECT_EQ(SimulationOptions::from(only.simulation).people, 2);
  EXPECT_FALSE(SimulationOptions::from(only.simulation).drive);
  EXPECT_THAT(only.probes, ElementsAre(1.0, 2.0));
  ASSERT_TRUE(only.half_turn);
  EXPECT_DOUBLE_EQ(only.half_turn->x, 3.0);
  EXPECT_DOUBLE_EQ(only.success.heading, 10.0 * kPi / 180.0);
  EXPECT_EQ(only.first_seed, 7);
  EXPECT_EQ(only.seeds, 3);
  const auto& values = only.cores.front().parameters.values();
  EXPECT_EQ(toText(values.at("update_min_d")), "0");
  EXPECT_EQ(toText(values.at("max_particles")), "500") << "a core's own option wins";
  ASSERT_THAT(only.events, SizeIs(3));
  EXPECT_EQ(only.events[0].what, What::kKidnap);
  EXPECT_DOUBLE_EQ(only.events[0].every, 3.0);
  EXPECT_DOUBLE_EQ(only.events[0].to.regions.at(0).low.x(), 0.0);
  EXPECT_DOUBLE_EQ(only.events[0].to.yaw_high, 1.0);
  EXPECT_EQ(only.events[1].what, What::kCarry);
  EXPECT_TRUE(only.events[1].is_garbage);
  EXPECT_EQ(only.events[2].what, What::kBlock);
  EXPECT_TRUE(only.events[2].is_sector);
  EXPECT_DOUBLE_EQ(only.events[2].share, 0.25);
}

TEST_F(ExperimentYaml, CasesSayWhatIsDifferentAndTheCommandLineWins) {
  const std::string lines =
      "duration: 5\nsimulation: {people: 1, furniture: true}\n"
      "cases:\n  - {label: a}\n  - {label: b, duration: 6, simulation: {people: 2}}\n";
  const Experiment plain = toy_.load(lines);
  ASSERT_THAT(plain.cases, SizeIs(2));
  EXPECT_DOUBLE_EQ(plain.cases[0].duration, 5.0);
  EXPECT_DOUBLE_EQ(plain.cases[1].duration, 6.0);
  EXPECT_EQ(SimulationOptions::from(plain.cases[1].simulation).people, 2);
  EXPECT_TRUE(SimulationOptions::from(plain.cases[1].simulation).furniture);
  EXPECT_NE(plain.cases[0].fingerprint, plain.cases[1].fingerprint);

  const Experiment other =
      toy_.load(lines, {{"duration", "3"}, {"simulation.people", "4"}, {"max_particles", "77"}});
  for (const auto& of_case : other.cases) {
    EXPECT_DOUBLE_EQ(of_case.duration, 3.0);
    EXPECT_EQ(SimulationOptions::from(of_case.simulation).people, 4);
    EXPECT_EQ(toText(of_case.cores.front().parameters.values().at("max_particles")), "77");
  }
  EXPECT_NE(other.cases[0].fingerprint, plain.cases[0].fingerprint);
  EXPECT_EQ(toy_.load(lines).cases[0].fingerprint, plain.cases[0].fingerprint);
}

TEST_F(ExperimentYaml, CanHaveAMapAsARobotMakesIt) {
  const ExperimentCase surveyed = toy_.load("map: surveyed\n").cases.front();
  const ExperimentCase drawn = toy_.load("").cases.front();
  EXPECT_NE(loadSite(surveyed).ground.map->lattice().origin().theta, 0.0);
  EXPECT_EQ(loadSite(drawn).ground.map->lattice().origin().theta, 0.0);
  EXPECT_NE(surveyed.fingerprint, drawn.fingerprint);
}

TEST_F(ExperimentYaml, ThatIsWrongIsRejectedWithWhatWasExpected) {
  expectRejected("durations: 3\n", "unknown key 'durations'");
  expectRejected("duration: soon\n", "'duration': got 'soon', expected a number in [0.1, ");
  expectRejected("duration: -1\n", "'duration': got '-1'");
  expectRejected("duration: .nan\n", "'duration': got '.nan'");
  expectRejected("start: somewhere\n", "'start': got 'somewhere', expected one of random");
  expectRejected("start: [1, 2]\n", "'start': got '[1, 2]', expected random, or [x, y, yaw]");
  expectRejected("start: {region: [1]}\n", "unknown key 'start.region'");
  expectRejected("start: {regions: [[0, 0, 1]]}\n", "'start.regions[0]': got '[0, 0, 1]'");
  expectRejected("start_known: perhaps\n", "'start_known': got 'perhaps', expected true or false");
  expectRejected("route: [[1, one]]\n", "'route[0]': got '[1, one]', expected a point");
  expectRejected("simulation: {peeple: 1}\n", "'simulation.peeple': got '1'");
  expectRejected("simulation: {people: -1}\n", "'simulation': option 'people': got '-1'");
  expectRejected("simulation: {seed: 1}\n", "'simulation.seed': got '1', expected nothing here");
  expectRejected("simulation: 3\n", "'simulation': got '3', expected a map");
  expectRejected("events: {what: kidnap}\n", "'events': got '{what: kidnap}', expected a list");
  expectRejected("events: [{what: fall, at: 1}]\n", "'events[0].what': got 'fall'");
  expectRejected("events: [{what: kidnap}]\n", "'events[0].at' is missing");
  expectRejected("events: [{what: kidnap, at: 1, share: 1}]\n", "unknown key 'events[0].share'");
  expectRejected("events: [{what: block, at: 1, for: 1, share: 3}]\n",
                 "'events[0].share': got '3', expected a number in [0, 1]");
  expectRejected("success: {scans: 0}\n", "'success.scans': got '0', expected a whole number");
  expectRejected("probes: soon\n", "'probes': got 'soon'");
  expectRejected("half_turn: [1]\n", "'half_turn': got '[1]'");
  expectRejected("seeds: {count: 0}\n", "'seeds.count': got '0'");
  expectRejected("options: [1]\n", "'options': got '[1]', expected a map");
  expectRejected("map: nosuch.yaml\n", "'map': got 'nosuch.yaml', expected a file");
  expectRejected("cases: [{label: a}, {label: a}]\n", "label 'a' twice");
  expectRejected("cases: [{label: a, duration: no}]\n", "'duration': got 'no'");
  expectRejected("cases: [{labl: a}]\n", "unknown key 'cases[0].labl'");
}

TEST_F(ExperimentYaml, ThatLacksSomethingIsRejected) {
  expectRejectedFile(toy_.write(""), "'cores' is missing");
  expectRejectedFile(toy_.write("cores: []\n"), "'cores': got '[]', expected a list of cores");
  expectRejectedFile(toy_.write("cores: [{preset: seed}]\n"), "'cores[0].filter' is missing");
  expectRejectedFile(toy_.write("cores: [{filter: kld}, {filter: kld}]\n"), "label 'kld' twice");
  expectRejectedFile(toy_.write("cores: [{filter: kld, options: {seed: 3}}]\n"),
                     "'cores[0].options.seed': got '3'");
  expectRejectedFile(toy_.write("cores: [{filter: kld, preset: best}]\n"),
                     "'cores[0].preset': got 'best', expected one of recommended, seed");
  const auto file = [&](const std::string& text) { return toy_.folder().write("x.yaml", text); };
  expectRejectedFile(file("name: x\n"), "'sentence' is missing");
  expectRejectedFile(file("name: x\nsentence: y\n"), "'world' is missing");
  expectRejectedFile(file("- 1\n"), "expected a map");
  expectRejectedFile(file("a: [1\n"), "x.yaml");
  expectRejectedFile(toy_.folder().file("nosuch.yaml"), "nosuch.yaml");
}

TEST_F(ExperimentYaml, WithBrokenTextNeverDoesMoreThanThrow) {
  const std::string text = readWhole(SOURCE_DIR "/config/experiments/kidnap.yaml");
  ASSERT_THAT(text, HasSubstr("kidnap"));
  Rng rng(4);
  int read = 0;
  for (int i = 0; i < 300; ++i) {
    std::string broken = text;
    for (int k = 0; k < 4; ++k) {
      broken[rng.below(broken.size())] = static_cast<char>(rng.uniform(1, 127));
    }
    if (i % 3 == 0) broken.resize(rng.below(broken.size()));
    try {
      loadExperiment(toy_.folder().write("broken.yaml", broken));
      ++read;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("broken.yaml"));
    }
  }
  EXPECT_LT(read, 300);
}

TEST(ShippedExperiments, CanBeRun) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/config/experiments")) {
    const Experiment experiment = loadExperiment(entry.path().string());
    ++files;
    for (const auto& of_case : experiment.cases) {
      const ExperimentSite site = loadSite(of_case);
      for (const auto& core : of_case.cores) checkCore(site, of_case, core);
    }
  }
  EXPECT_GE(files, 7);
}

}  // namespace
}  // namespace adaptive_localization
