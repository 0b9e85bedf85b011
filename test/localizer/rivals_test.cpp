// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/rivals.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// Rivals in a world, and what a robot there sees.
struct Judged {
  explicit Judged(std::shared_ptr<const OccupancyGrid> world) : map(std::move(world)) {}

  void see(const Pose2& truth, const Pose2& believed, const Pose2& motion = {}) {
    rivals.observe(motion, believed, laser.observe(map, truth));
  }

  std::shared_ptr<const OccupancyGrid> map;
  std::shared_ptr<const DistanceField> field = std::make_shared<const DistanceField>(*map);
  Rivals rivals{RivalsOptions{}, map, field,
                std::make_shared<Places>(map, field, EnergyGridOptions{}, GlobalSearchOptions{})};
  ToyLaser laser{91, -kPi / 2, kPi / 2, 12.0};
};

/// Half a turn about the middle of symmetricWorld().
Pose2 twinOf(const Pose2& pose) {
  return {6.0 - pose.x, 3.0 - pose.y, wrapAngle(pose.theta + kPi)};
}

constexpr double kWay = 0.3;  // rival_distance

TEST(Rivals, ThereAreNoneUntilDoubtsAreRaised) {
  Judged judged(asymmetricWorld());
  EXPECT_TRUE(judged.rivals.isSettled());
  judged.see({1.0, 1.0, 0.0}, {4.0, 2.0, 1.0});
  EXPECT_TRUE(judged.rivals.isSettled());
  EXPECT_TRUE(judged.rivals.modes().empty());
  EXPECT_DOUBLE_EQ(judged.rivals.shareOf({4.0, 2.0, 1.0}), 1.0);
}

TEST(Rivals, AreRuledOutByOneScanWhereNothingLooksAlike) {
  Judged judged(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  judged.rivals.open();
  judged.see(truth, truth);
  EXPECT_TRUE(judged.rivals.isSettled());
}

/// It used to be fitted to the scan for ever, each step no worse than the one before.
TEST(Rivals, DoNotTakeInABeliefThatIsNoPlace) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const Pose2& nowhere : {Pose2{kNaN, 1.0, 0.0}, Pose2{1.0, 1.0, kNaN}}) {
    Judged judged(symmetricWorld());
    const Pose2 truth{1.0, 1.0, 0.3};
    judged.rivals.open();
    judged.see(truth, truth);
    const std::size_t known = judged.rivals.modes().size();
    EXPECT_GT(known, 1U);
    for (int scan = 0; scan < 3; ++scan) judged.see(truth, nowhere);
    EXPECT_EQ(judged.rivals.modes().size(), known);
  }
}

TEST(Rivals, KnowBetterThanAFilterThatBelievesInAnotherPlace) {
  Judged judged(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  const Pose2 wrong{8.0, 1.0, 2.0};
  judged.rivals.open();
  for (int scan = 1; scan <= 3; ++scan) {
    judged.see(truth, wrong, {});
    EXPECT_FALSE(judged.rivals.isSettled());
    EXPECT_EQ(judged.rivals.contradictions(), scan);
    EXPECT_DOUBLE_EQ(judged.rivals.shareOf(wrong), 0.0);
    ASSERT_EQ(judged.rivals.modes().size(), 1U);
    EXPECT_THAT(judged.rivals.modes().front().T_map_base, PoseNear(truth, 0.1, 0.05));
  }
  judged.see(truth, truth);
  EXPECT_TRUE(judged.rivals.isSettled());
  EXPECT_EQ(judged.rivals.contradictions(), 0);
}

TEST(Rivals, JudgeWhatSomebodyTells) {
  Judged judged(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  const Observations seen = judged.laser.observe(judged.map, truth);
  EXPECT_EQ(judged.rivals.judge({8.0, 1.0, 2.0}, seen), Verdict::kWrong);
  EXPECT_EQ(judged.rivals.judge(truth, seen), Verdict::kRight);
  EXPECT_EQ(judged.rivals.judge(truth * Pose2{0.1, 0.1, 0.05}, seen), Verdict::kRight);
  EXPECT_EQ(judged.rivals.judge(truth, Observations{}), Verdict::kUnknown);

  Judged twins(symmetricWorld());
  const Pose2 place{1.0, 1.0, 0.3};
  const Observations either = twins.laser.observe(twins.map, place);
  EXPECT_EQ(twins.rivals.judge(twinOf(place), either), Verdict::kPossible);
}

TEST(Rivals, NeverDriftApartWhereTwoPlacesLookTheSame) {
  Judged judged(symmetricWorld());
  judged.rivals.open();
  Pose2 truth{2.3, 1.0, 0.0};
  for (int i = 0; i < 60; ++i) {
    const Pose2 motion{i % 12 < 6 ? 0.2 : -0.2, 0.0, i % 2 ? 0.05 : -0.05};
    truth = truth * motion;
    judged.see(truth, truth, motion);  // the filter believes in one of them only
    ASSERT_FALSE(judged.rivals.isSettled()) << i;
    ASSERT_EQ(judged.rivals.modes().size(), 2U) << i;
    EXPECT_NEAR(judged.rivals.shareOf(truth), 0.5, 0.05) << i;
    EXPECT_NEAR(judged.rivals.shareOf(twinOf(truth)), 0.5, 0.05) << i;
  }
}

TEST(Rivals, ARobotThatStandsStillLearnsNothingNew) {
  Judged judged(symmetricWorld());
  judged.rivals.open();
  const Pose2 truth{2.3, 1.0, 0.0};
  judged.see(truth, truth);
  const double share = judged.rivals.shareOf(truth);
  for (int i = 0; i < 20; ++i) judged.see({2.31, 1.0, 0.01}, truth);
  EXPECT_DOUBLE_EQ(judged.rivals.shareOf(truth), share);
}

TEST(Rivals, AskWhereACarriedRobotIs) {
  Judged judged(asymmetricWorld());
  const Pose2 before{2.0, 3.0, -0.5};
  Pose2 after{3.2, 2.0, 0.3};
  judged.rivals.open(before);
  judged.see(after, before);
  EXPECT_FALSE(judged.rivals.isSettled());
  EXPECT_LT(judged.rivals.shareOf(before), 0.01);
  EXPECT_GT(judged.rivals.shareOf(after), 0.5);
  const Pose2 motion{kWay, 0.0, 0.0};
  after = after * motion;
  judged.see(after, after, motion);
  EXPECT_TRUE(judged.rivals.isSettled());
}

TEST(Rivals, AreLeftOpenByACoveredLaserAndSettledWhenItSeesTheSameAgain) {
  Judged judged(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  judged.rivals.open(truth);
  std::vector<Eigen::Vector2d> cover;
  for (int i = -80; i <= 80; ++i) {
    const double range = 0.25 + 0.1 * (i % 3);
    cover.emplace_back(range * std::cos(0.0175 * i), range * std::sin(0.0175 * i));
  }
  for (int i = 0; i < 5; ++i) {
    Observations covered = hitsAt(cover, 12.0);
    covered.scan.view.start = -kPi / 2;
    covered.scan.view.width = kPi;
    judged.rivals.observe({}, truth, covered);
    EXPECT_FALSE(judged.rivals.isSettled()) << i;
  }
  const Pose2 motion{kWay, 0.0, 0.0};
  judged.see(truth * motion, truth * motion, motion);
  EXPECT_TRUE(judged.rivals.isSettled());
}

TEST(Rivals, AScanWithoutHitsChangesNothing) {
  Judged judged(asymmetricWorld());
  judged.rivals.open();
  judged.rivals.observe({}, {2.0, 3.0, 0.0}, Observations{});
  EXPECT_FALSE(judged.rivals.isSettled());
  EXPECT_TRUE(judged.rivals.modes().empty());
}

TEST(Rivals, OthersGoOnWithWhatTheyKnow) {
  Judged one(symmetricWorld());
  Judged other(symmetricWorld());
  const Pose2 truth{2.3, 1.0, 0.0};
  one.rivals.open();
  one.see(truth, truth);
  other.rivals.goOnFrom(one.rivals);
  EXPECT_FALSE(other.rivals.isSettled());
  EXPECT_DOUBLE_EQ(other.rivals.shareOf(truth), one.rivals.shareOf(truth));
}

}  // namespace
}  // namespace adaptive_localization
