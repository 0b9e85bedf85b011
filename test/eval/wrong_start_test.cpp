// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <stdexcept>

#include "../../src/eval/experiment_drive.hpp"
#include "../../src/eval/experiment_judge.hpp"
#include "eval/experiment_result.hpp"
#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

class WrongStart : public testing::Test {
 protected:
  ExperimentCase load(const std::string& lines) const { return toy_.load(lines).cases.front(); }

  void expectRejected(const std::string& lines, const std::string& words) const {
    EXPECT_THAT([&] { toy_.load(lines); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr(words)))
        << lines;
  }

  ToyExperiment toy_;
};

TEST_F(WrongStart, IsAsFarFromTheTruthAsAskedForAndAPlaceToStand) {
  const ExperimentCase of_case = load("told: {off_by: 1.5, turned_by: 0.5}\n");
  EXPECT_TRUE(of_case.is_start_known);
  const ExperimentSite site = loadSite(of_case);
  for (int seed = 1; seed < 30; ++seed) {
    const ExperimentDrive drive(site, of_case, seed);
    EXPECT_NEAR(distance(drive.told(), drive.truth()), 1.5, 1e-9);
    EXPECT_NEAR(wrapAngle(drive.told().theta - drive.truth().theta), 0.5, 1e-9);
    EXPECT_TRUE(site.free_space->contains({drive.told().x, drive.told().y}));
  }
}

TEST_F(WrongStart, CanBeAlongALineEitherWay) {
  const ExperimentCase of_case = load("told: {off_by: [1.5, 0.2]}\n");
  const ExperimentSite site = loadSite(of_case);
  int forth = 0, back = 0;
  for (int seed = 1; seed < 30; ++seed) {
    const ExperimentDrive drive(site, of_case, seed);
    const double sign = drive.told().x > drive.truth().x ? 1.0 : -1.0;
    EXPECT_NEAR(drive.told().x - drive.truth().x, sign * 1.5, 1e-9);
    EXPECT_NEAR(drive.told().y - drive.truth().y, sign * 0.2, 1e-9);
    EXPECT_EQ(drive.told().theta, drive.truth().theta);
    EXPECT_TRUE(site.free_space->contains({drive.told().x, drive.told().y}));
    (sign > 0.0 ? forth : back)++;
  }
  EXPECT_GT(forth, 3);
  EXPECT_GT(back, 3);
}

TEST_F(WrongStart, CanBeAPose) {
  const ExperimentCase of_case = load("start: [1, 0.6, 0]\ntold: [5, 3, 1]\n");
  const ExperimentDrive drive(loadSite(of_case), of_case, 1);
  EXPECT_NEAR(distance(drive.told(), {5.0, 3.0, 1.0}), 0.0, 1e-12);
  EXPECT_NEAR(drive.told().theta, 1.0, 1e-12);
  EXPECT_LT(distance(drive.truth(), {1.0, 0.6, 0.0}), 0.05);
}

TEST_F(WrongStart, IsTheTruthUnlessAskedFor) {
  const ExperimentCase of_case = load("start_known: true\n");
  const ExperimentDrive drive(loadSite(of_case), of_case, 1);
  EXPECT_EQ(distance(drive.told(), drive.truth()), 0.0);
}

TEST_F(WrongStart, ThatCannotBeIsRejected) {
  expectRejected("told: [1, 2]\n", "'told': got '[1, 2]', expected [x, y, yaw]");
  expectRejected("told: {off: 3}\n", "unknown key 'told.off'");
  expectRejected("told: {off_by: -1}\n", "'told.off_by': got '-1'");
  expectRejected("told: {off_by: [1]}\n",
                 "'told.off_by': got '[1]', expected a number of metres, or [x, y]");
  expectRejected("told: {off_by: 1}\nstart_known: false\n", "'start_known': got 'false'");
  expectRejected("success: {within: soon}\n", "'success.within': got 'soon'");
  expectRejected("bounds: 3\n", "'bounds': got '3', expected true or false");
  for (const std::string off_by : {"50", "[0, 50]"}) {
    const ExperimentCase far = load("told: {off_by: " + off_by + "}\n");
    EXPECT_THAT([&] { ExperimentDrive(loadSite(far), far, 1); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("50.0")));
  }
}

TEST_F(WrongStart, LooksForFilesThatOptionsNameFromItsOwnPlace) {
  const ExperimentCase of_case = load("options: {line_map: world.yaml}\n");
  const auto& values = of_case.cores.front().parameters.values();
  EXPECT_EQ(toText(values.at("line_map")), toy_.folder().file("world.yaml"));
  const ExperimentCase same = load("options: {line_map: world}\n");
  EXPECT_EQ(toText(same.cores.front().parameters.values().at("line_map")), same.world);
  expectRejected("options: {line_map: nosuch.yaml}\n", "'options.line_map': got 'nosuch.yaml'");
}

/// A trial with one second for it, in which the estimate is wrong for so many scans, and then
/// right.
ExperimentResult trial(int wrong, Status status, int right) {
  ExperimentCase of_case;
  of_case.success.within = 1.0;
  ExperimentJudge judge(of_case);
  judge.begin(Trial::Kind::kWrongStart, 0.0, {});
  for (int i = 1; i <= wrong + right; ++i) {
    JudgedScan scan;
    scan.stamp = 0.1 * i;
    scan.T_map_base = Pose2{};
    scan.answer.T_map_base = Pose2{i <= wrong ? 5.4 : 0.0, 0.0, 0.0};
    scan.answer.status = i <= wrong ? status : Status::kTracking;
    judge.observe(scan);
  }
  ExperimentResult result = judge.finish();
  result.id = {"toy", "hall", "ekf", 1, "same"};
  return result;
}

TEST_F(WrongStart, MustBeCorrectedInTimeOrFlagged) {
  const Trial prompt = trial(9, Status::kTracking, 10).trials.front();
  EXPECT_EQ(prompt.within_s, 1.0);
  EXPECT_LE(prompt.found_s.value(), 1.0) << "found at exactly a second";
  const Trial late = trial(15, Status::kTracking, 10).trials.front();
  EXPECT_GT(late.found_s.value(), 1.0);
  EXPECT_GT(late.late_tracking, 0) << "it said tracking";
  const Trial flagged = trial(15, Status::kLost, 10).trials.front();
  EXPECT_GT(flagged.found_s.value(), 1.0);
  EXPECT_EQ(flagged.late_tracking, 0);
}

TEST_F(WrongStart, HasNoTimeUnlessAskedFor) {
  ExperimentJudge judge{ExperimentCase()};
  judge.begin(Trial::Kind::kWrongStart, 0.0, {});
  EXPECT_EQ(judge.finish().trials.front().within_s, std::nullopt);
}

}  // namespace
}  // namespace adaptive_localization
