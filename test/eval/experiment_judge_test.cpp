// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/eval/experiment_judge.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

/// Feeds a judge with scans a tenth of a second apart of a robot that stands at the origin.
class Judge : public testing::Test {
 protected:
  void see(const Pose2& estimate, Status status, int times = 1, bool is_on_floor = true) {
    for (int i = 0; i < times; ++i) {
      JudgedScan scan;
      scan.stamp = 0.1 * ++count_;
      if (is_on_floor) scan.T_map_base = Pose2{};
      scan.answer.T_map_base = scan.answer.T_map_odom = estimate;
      scan.answer.status = status;
      scan.answer.confidence = confidence_;
      scan.answer.updated = true;
      scan.answer.modes = modes_;
      scan.answer.estimate.share_elsewhere = share_elsewhere_;
      scan.particles = 10 * count_;
      scan.spread = spread_;
      scan.update_ms = count_;
      judge_.observe(scan);
    }
  }

  static constexpr Pose2 kRight{0.1, 0.0, 0.05}, kNearly{0.3, 0.0, 0.0}, kWrong{1.0, 0.0, 0.0};
  ExperimentCase case_ = [] {
    ExperimentCase of_case;
    of_case.half_turn = Pose2{2.0, 1.0, 0.0};
    of_case.probes = {0.25, 0.5};
    return of_case;
  }();
  ExperimentJudge judge_{case_};
  std::vector<Mode> modes_;
  double confidence_{0.0}, share_elsewhere_{0.0};
  std::optional<double> spread_;
  int count_{0};
};

constexpr Pose2 Judge::kRight, Judge::kNearly, Judge::kWrong;

TEST_F(Judge, NotesParticlesSecondBySecondAndHowOftenTheyAreDrawnElsewhere) {
  judge_.begin(Trial::Kind::kStart, 0.0, {});
  see(kRight, Status::kTracking, 11);
  share_elsewhere_ = 0.3;
  see(kRight, Status::kTracking, 12);
  const auto result = judge_.finish();
  EXPECT_EQ(result.looks_elsewhere, 12);
  EXPECT_EQ(result.particles_by_s, (std::vector<int>{10, 100, 200}));
}

TEST_F(Judge, ValidatesTheMeanOfParticlesThatAreTogetherAndNotWrong) {
  judge_.begin(Trial::Kind::kStart, 0.0, {});
  see(kRight, Status::kGlobalizing);  // no particles
  spread_ = 0.15;
  see(kRight, Status::kGlobalizing);
  spread_ = 0.13;
  see(kWrong, Status::kGlobalizing, 2);
  see(kNearly, Status::kGlobalizing);
  see(kWrong, Status::kGlobalizing);
  judge_.begin(Trial::Kind::kKidnap, 0.6, {});
  see(kWrong, Status::kTracking, 3);
  const auto trials = judge_.finish().trials;
  ASSERT_TRUE(trials.at(0).validated_s);
  EXPECT_NEAR(*trials.at(0).validated_s, 0.5, 1e-9);
  EXPECT_EQ(trials.at(0).wrongly_validated, 2);
  EXPECT_FALSE(trials.at(1).validated_s);
  EXPECT_EQ(trials.at(1).wrongly_validated, 3);
}

TEST_F(Judge, CountsTheRobotAsFoundFromTheFirstOfThreeRightScans) {
  judge_.begin(Trial::Kind::kStart, 0.0, {});
  see(kWrong, Status::kGlobalizing, 2);
  see(kRight, Status::kGlobalizing, 2);
  see(kNearly, Status::kAmbiguous);
  see(kRight, Status::kGlobalizing, 2);
  see(kRight, Status::kTracking, 4);
  const auto result = judge_.finish();
  ASSERT_EQ(result.trials.size(), 1U);
  const Trial& trial = result.trials.front();
  ASSERT_TRUE(trial.found_s && trial.told_s);
  EXPECT_NEAR(*trial.found_s, 0.6, 1e-9);
  EXPECT_NEAR(*trial.told_s, 0.8, 1e-9);
  EXPECT_EQ(trial.searching, 3);
  EXPECT_EQ(trial.searching_ambiguous, 1);
  EXPECT_EQ(trial.searching_tracking, 0);
  EXPECT_EQ(trial.end_status, "tracking");
  EXPECT_FALSE(trial.is_silent_failure);
  EXPECT_NEAR(result.settled_s, 0.1, 1e-9) << "after the scan that made three";
  EXPECT_NEAR(result.rms_m, 0.1, 1e-9);
  EXPECT_EQ(result.status.at("globalizing"), 6);
  EXPECT_EQ(result.particles_first, 10);
  EXPECT_DOUBLE_EQ(result.update_ms_median, 6.0);
}

TEST_F(Judge, JudgesEachPlaceTheRobotIsPutAtAnew) {
  judge_.begin(Trial::Kind::kKnownStart, 0.0, {});
  see(kRight, Status::kTracking, 5);
  judge_.begin(Trial::Kind::kKidnap, 0.5, {});
  see(kWrong, Status::kTracking, 3);
  see(kWrong, Status::kLost, 1);
  see(kWrong, Status::kTracking, 2);
  const auto result = judge_.finish();
  ASSERT_EQ(result.trials.size(), 2U);
  EXPECT_TRUE(result.trials[0].found_s);
  EXPECT_FALSE(result.trials[1].found_s);
  EXPECT_TRUE(result.trials[1].is_silent_failure);
  EXPECT_EQ(result.trials[1].searching_tracking, 5);
  EXPECT_EQ(result.silently_wrong, 5);
  EXPECT_NEAR(result.silently_wrong_s, 0.3, 1e-9) << "the longest spell";
  EXPECT_EQ(result.left_tracking, 0) << "after a kidnap that is no false alarm";
  EXPECT_EQ(result.false_jumps, 0);
  EXPECT_EQ(result.jumps, 1);
}

TEST_F(Judge, CountsFalseAlarms) {
  judge_.begin(Trial::Kind::kKnownStart, 0.0, {});
  see(kRight, Status::kTracking, 5);
  see(kRight, Status::kLost, 2);
  see(kRight, Status::kTracking, 2);
  see(kRight, Status::kAmbiguous, 1);
  see(kWrong, Status::kTracking, 1);
  const auto result = judge_.finish();
  EXPECT_EQ(result.left_tracking, 2);
  EXPECT_EQ(result.false_jumps, 1);
  EXPECT_NEAR(result.max_m, 1.0, 1e-9);
}

TEST_F(Judge, CountsAsJumpsWhatOdometryDoesNotExplain) {
  judge_.begin(Trial::Kind::kStart, 0.0, {});
  see({}, Status::kUninitialised);
  see(kWrong, Status::kGlobalizing, 2);  // from nowhere
  see({1.4, 0.0, 0.3}, Status::kAmbiguous);
  see({1.4, 0.0, 0.7}, Status::kAmbiguous);  // turns by 23 degrees
  see(kRight, Status::kAmbiguous);
  EXPECT_EQ(judge_.finish().jumps, 2);
}

TEST_F(Judge, NotesWhenAPlaceThatWasKnownOrFoundWasLeft) {
  judge_.begin(Trial::Kind::kKnownStart, 0.0, {});
  see(kNearly, Status::kTracking, 2);
  see(kWrong, Status::kLost, 2);
  see(kRight, Status::kTracking, 5);
  judge_.begin(Trial::Kind::kKidnap, 0.9, {});
  see(kWrong, Status::kLost, 2);
  see(kRight, Status::kTracking, 4);
  judge_.begin(Trial::Kind::kKidnap, 1.5, {});
  see(kWrong, Status::kLost, 1);
  see(kRight, Status::kTracking, 3);
  see(kWrong, Status::kTracking, 1);
  const auto trials = judge_.finish().trials;
  ASSERT_EQ(trials.size(), 3U);
  EXPECT_NEAR(trials[0].left_s.value(), 0.3, 1e-9) << "a place that was told was known at once";
  EXPECT_FALSE(trials[1].left_s);
  EXPECT_NEAR(trials[2].left_s.value(), 0.5, 1e-9);
}

TEST_F(Judge, HoldsErrorsAgainstConfidence) {
  judge_.begin(Trial::Kind::kKnownStart, 0.0, {});
  confidence_ = 0.95;
  see(kRight, Status::kTracking, 3);
  see(kWrong, Status::kTracking, 1);
  confidence_ = 0.2;
  see(kWrong, Status::kAmbiguous, 2);
  see(kRight, Status::kTracking, 5, false);
  const Calibration calibration = judge_.finish().calibration;
  EXPECT_EQ(calibration.scans[9], 4);
  EXPECT_EQ(calibration.near[9], 3);
  EXPECT_EQ(calibration.scans[2], 2) << "a robot that is carried is nowhere";
  EXPECT_EQ(calibration.near[2], 0);
}

TEST_F(Judge, TellsWhatHappensWhileTheRobotIsCarriedApart) {
  judge_.begin(Trial::Kind::kKnownStart, 0.0, {});
  see(kRight, Status::kTracking, 5);
  judge_.lift();
  see(kRight, Status::kTracking, 1, false);
  see(kWrong, Status::kLost, 2, false);
  const auto result = judge_.finish();
  EXPECT_EQ(result.carried, 3);
  EXPECT_EQ(result.carried_tracking, 1);
  EXPECT_EQ(result.carried_jumps, 1);
  EXPECT_EQ(result.silently_wrong, 0);
  EXPECT_EQ(result.left_tracking, 0);
}

TEST_F(Judge, KnowsBothPlacesThatLookTheSame) {
  judge_.begin(Trial::Kind::kStart, 0.0, {});
  Mode here, there;
  there.T_map_base = {4.0, 2.0, kPi};
  here.mass = 0.6;
  there.mass = 0.4;
  modes_ = {here};
  see(kRight, Status::kAmbiguous, 1);
  modes_ = {here, there};
  see(kRight, Status::kAmbiguous, 3);
  const auto result = judge_.finish();
  EXPECT_EQ(result.both_share, 0.75);
  EXPECT_TRUE(result.has_both_at_end);
  EXPECT_NEAR(result.first_mass, 0.6, 1e-9);
  EXPECT_NEAR(result.second_mass, 0.3, 1e-9);
}

TEST_F(Judge, NotesTheErrorAtTheMomentsAskedFor) {
  judge_.begin(Trial::Kind::kStart, 0.0, {});
  see(kRight, Status::kTracking, 4);
  see(kWrong, Status::kTracking, 4);
  const auto errors = judge_.finish().probe_errors_m;
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_DOUBLE_EQ(errors[0], 0.1);
  EXPECT_DOUBLE_EQ(errors[1], 1.0);
}

}  // namespace
}  // namespace adaptive_localization
