// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/hypotheses.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "observation/heading_prior.hpp"
#include "observation/landmark_model.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kTruth{2.0, 3.0, -0.5};
const Pose2 kWrong{8.0, 1.0, 2.0};
constexpr double kUsual = 0.02;  // m

Observations seenAt(const Pose2& pose) {
  return ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(asymmetricWorld(), pose);
}

/// Something stands halfway to what so many beams would see.
Observations occludedAt(const Pose2& pose, Eigen::Index beams) {
  Observations seen = seenAt(pose);
  seen.scan.range.head(beams) *= 0.5F;
  return seen;
}

double massOf(const Hypotheses& hypotheses, const Pose2& pose) {
  for (const Mode& mode : hypotheses.modes()) {
    if (std::hypot(mode.T_map_base.x - pose.x, mode.T_map_base.y - pose.y) < 0.3) return mode.mass;
  }
  return 0.0;
}

TrackingOdds tracked(double metres) {
  TrackingOdds odds(true);
  odds.find();
  odds.earn({metres, 0.0, 0.0});
  return odds;
}

TEST(Hypotheses, APlaceThatDoesNotFitIsRuledOut) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.add(kWrong, 0.0);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  hypotheses.prune();
  EXPECT_FALSE(hypotheses.knows(kWrong));
  ASSERT_EQ(hypotheses.modes().size(), 1U);
  EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(kTruth, 0.05, 0.02));
  EXPECT_LT(hypotheses.leastError(), 0.02);
}

Senses compass() {
  auto senses = std::make_shared<ComposedModel>();
  senses->add(std::make_unique<HeadingPrior>());
  return senses;
}

TEST(Hypotheses, ACompassDecidesBetweenPlacesThatLookTheSame) {
  const Pose2 truth{1.0, 1.0, 0.0};
  const Pose2 twin{5.0, 2.0, kPi};
  Hypotheses hypotheses(Ground(symmetricWorld()), compass());
  hypotheses.add(twin, 0.0);
  hypotheses.add(truth, 0.0);
  Observations seen = ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(symmetricWorld(), truth);
  seen.heading = Heading{0.1, 0.1};
  for (int i = 0; i < 4; ++i) hypotheses.weigh(seen, News{}, kUsual);
  hypotheses.prune();
  ASSERT_EQ(hypotheses.modes().size(), 1U);
  EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(truth, 0.05, 0.02));
}

TEST(Hypotheses, ACompassAloneDoesNotRuleOutWhereTheRobotWasKnownToBe) {
  const Pose2 truth{1.0, 1.0, 0.0};
  const Pose2 twin{5.0, 2.0, kPi};
  TrackingOdds earned(true);
  earned.earn({3.0, 0.0, 0.0});
  Hypotheses hypotheses(Ground(symmetricWorld()), compass());
  hypotheses.addKept(truth, earned);
  hypotheses.add(twin, 0.0);
  Observations seen = ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(symmetricWorld(), truth);
  seen.heading = Heading{kPi, 0.1};
  for (int i = 0; i < 100; ++i) hypotheses.weigh(seen, News{}, kUsual);
  hypotheses.prune();
  EXPECT_GT(massOf(hypotheses, truth), 0.99);
}

TEST(Hypotheses, LandmarksThatWereMovedDoNotRuleOutWhereTheLaserKnowsTheRobot) {
  const Pose2 truth{1.0, 1.0, 0.0};
  const Pose2 twin{5.0, 2.0, kPi};
  const auto map = symmetricWorld();
  auto senses = std::make_shared<ComposedModel>();
  senses->add(std::make_unique<LandmarkModel>(LandmarkOptions{},
                                              LandmarkMap({{0, twin * Eigen::Vector2d(1.0, 0.0)}}),
                                              map, std::make_shared<const DistanceField>(*map)));
  TrackingOdds earned(true);
  earned.earn({3.0, 0.0, 0.0});
  Hypotheses hypotheses(Ground(map), senses);
  hypotheses.addKept(truth, earned);
  hypotheses.add(twin, 0.0);
  Observations seen = ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(map, truth);
  seen.landmarks = {{0, 1.0, 0.0, 0.1, 0.05}};
  for (int i = 0; i < 100; ++i) hypotheses.weigh(seen, News{}, kUsual);
  hypotheses.prune();
  EXPECT_GT(massOf(hypotheses, truth), 0.99);
}

TEST(Hypotheses, WhereMuchIsUsualLittleIsSaid) {
  double before = 1.0;
  for (const double usual : {0.02, 0.1, 0.3}) {  // m
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.add(kTruth, 0.0);
    hypotheses.add(kWrong, 0.0);
    hypotheses.weigh(seenAt(kTruth), News{}, usual);
    EXPECT_LE(massOf(hypotheses, kTruth), before);
    before = massOf(hypotheses, kTruth);
  }
  EXPECT_LT(before, 0.95);
}

/// From 0.12 m on evidence falls with the square of what is usual, and by what is tolerated.
TEST(Hypotheses, WhereErrorsAreTheMapsManyScansSayNoMoreThanOne) {
  const auto logOddsOfTruth = [](double usual) {
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.add(kTruth, 0.0);
    hypotheses.add(kWrong, 0.0);
    hypotheses.weigh(seenAt(kTruth), News{0.2, 0.2}, usual);
    const double mass = massOf(hypotheses, kTruth);
    return std::log(mass / (1.0 - mass));
  };
  EXPECT_GT(logOddsOfTruth(0.12), 1.0);
  EXPECT_LT(logOddsOfTruth(0.24), 0.2 * logOddsOfTruth(0.12));
  EXPECT_GT(logOddsOfTruth(0.12), 0.3 * logOddsOfTruth(0.06)) << "not below";
}

/// The field of a world with thick walls elsewhere, whose depth varies by more than 1 m.
std::shared_ptr<const DistanceField> fieldWithRoughWalls(const OccupancyGrid& world) {
  const Lattice& inner = world.lattice();
  const Lattice lattice(3 * inner.width(), inner.height(), inner.resolution(), inner.origin());
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const Cell cell = lattice.cell(i);
    const int depth = cell.x / 30 % 2 == 0 ? 6 : 28;
    const bool is_wall = cell.x > inner.width() + 40 && cell.y % 40 < depth;
    cells[i] = inner.contains(cell) ? world.at(cell)
               : is_wall            ? OccupancyGrid::kOccupied
                                    : OccupancyGrid::kFree;
  }
  return std::make_shared<const DistanceField>(OccupancyGrid(lattice, std::move(cells)));
}

TEST(Hypotheses, WhereWallsAreRoughLittleIsSaid) {
  const auto world = asymmetricWorld();
  const Ground rough(world, fieldWithRoughWalls(*world));
  ASSERT_GT(rough.field->quality().roughness(), 0.05);
  const auto massOfOther = [](const Ground& ground, const Pose2& other) {
    Hypotheses hypotheses(ground);
    hypotheses.add(kTruth, 0.0);
    hypotheses.add(other, 0.0);
    hypotheses.weigh(seenAt(kTruth), News{}, 0.1);
    return hypotheses.modes().back().mass;
  };
  int spared = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 other{1.0 + i % 10, 0.7 + i / 10 % 5, 1.5 * (i / 50)};
    if (areSamePlace(other, kTruth)) continue;
    const double before = massOfOther(world, other), now = massOfOther(rough, other);
    EXPECT_GE(now, before - 1e-9) << i;
    spared += now > 2.0 * before && now > 0.1 ? 1 : 0;
  }
  EXPECT_GT(spared, 0);
}

/// What a scan takes from the odds of a place where some of it does not fit.
double lossWhereTheBestHas(double log_odds) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, log_odds);
  hypotheses.add(kWrong, log_odds);
  hypotheses.weigh(seenAt(kTruth), News{0.1, 1.0}, kUsual);  // in full: places are new
  hypotheses.weigh(seenAt(kTruth), News{0.1, 1.0}, kUsual);
  return std::log(massOf(hypotheses, kTruth) / massOf(hypotheses, kWrong));
}

TEST(Hypotheses, WhereEvenTheLikeliestHasLostOddsAScanSaysLess) {
  const double lost = lossWhereTheBestHas(0.0);
  EXPECT_GT(lost, 1.0);
  EXPECT_NEAR(lossWhereTheBestHas(-6.0), 0.5 * lost, 0.01 * lost);
  EXPECT_NEAR(lossWhereTheBestHas(-18.0), 0.25 * lost, 0.01 * lost);
  EXPECT_NEAR(lossWhereTheBestHas(6.0), lost, 0.01 * lost) << "it has none to make up for";
}

/// Of something that the map does not have, say.
TEST(Hypotheses, AScanThatFitsNowhereSaysLittle) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.add(kWrong, 0.0);
  const Observations seen = occludedAt(kTruth, 60);
  hypotheses.weigh(seen, News{}, kUsual);
  EXPECT_GT(hypotheses.leastError(), 0.2);
  EXPECT_GT(massOf(hypotheses, kWrong), std::exp(-1.0) / (1.0 + std::exp(-1.0)) - 1e-9);
}

TEST(Hypotheses, AScanThatFitsNowhereSaysLeastOfAKeptPlace) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addKept(kWrong, TrackingOdds(true));
  hypotheses.add(kTruth, 0.0);
  const Observations seen = occludedAt(kTruth, 60);
  for (int i = 0; i < 20; ++i) hypotheses.weigh(seen, News{}, kUsual);
  EXPECT_GT(massOf(hypotheses, kWrong), 0.99);
}

/// What stands before some beams makes a scan fit badly everywhere, and still twice as well where
/// the robot is: it tells, but not against a place that was known.
TEST(Hypotheses, AScanThatFitsNowhereButFarBetterInOnePlaceTells) {
  for (const bool is_kept : {false, true}) {
    SCOPED_TRACE(is_kept);
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.addKept(kWrong, TrackingOdds(is_kept));
    hypotheses.add(kTruth, 0.0);
    const Observations seen = occludedAt(kTruth, 25);
    for (int i = 0; i < 4; ++i) hypotheses.weigh(seen, News{}, kUsual);
    EXPECT_GT(hypotheses.leastError(), 0.1);
    const double odds = std::log(massOf(hypotheses, kWrong) / massOf(hypotheses, kTruth));
    if (is_kept) {
      EXPECT_GT(odds, TrackingOdds(true).value() - 4 * 0.2 - 0.01);
    } else {
      EXPECT_LT(odds, -4.6);
    }
    EXPECT_EQ(hypotheses.refuted() > 0.0, is_kept) << "most does not fit there";
  }
}

TEST(Hypotheses, OddsEarnedBeforeCount) {
  Hypotheses hypotheses(symmetricWorld());
  const Pose2 here{2.3, 1.0, 0.0};
  const Pose2 twin{3.7, 2.0, kPi};
  hypotheses.add(here, 3.0);
  hypotheses.add(twin, 0.0);
  const auto seen = ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(symmetricWorld(), twin);
  for (int i = 0; i < 5; ++i) hypotheses.weigh(seen, News{}, kUsual);
  EXPECT_NEAR(std::log(massOf(hypotheses, here) / massOf(hypotheses, twin)), 3.0, 0.01);
}

TEST(Hypotheses, RideOnTheOdometry) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.ride({1.0, 0.5, 0.2});
  EXPECT_THAT(hypotheses.modes().front().T_map_base,
              PoseNear(kTruth * Pose2{1.0, 0.5, 0.2}, 1e-9, 1e-9));
}

TEST(Hypotheses, AScanThatIsNotNewSaysNothingMore) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.add(kTruth * Pose2{0.8, 0.0, 0.0}, 2.0);
  hypotheses.weigh(seenAt(kTruth), News{}, 0.3);
  const double mass = massOf(hypotheses, kTruth);
  for (int i = 0; i < 20; ++i) hypotheses.weigh(seenAt(kTruth), News{0.0, 0.0}, 0.3);
  EXPECT_DOUBLE_EQ(massOf(hypotheses, kTruth), mass);
}

/// What scans that are new by a fifth each say of some places against the true one.
std::vector<double> saidOf(const std::vector<Pose2>& places, int scans, double lead = 10.0) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, lead);
  for (const Pose2& place : places) hypotheses.add(place, 0.0);
  for (int i = 0; i < scans; ++i) hypotheses.weigh(seenAt(kTruth), News{0.2, 0.2}, 0.3);
  const std::vector<Mode> modes = hypotheses.modes();
  std::vector<double> said;
  for (const Mode& mode : modes) said.push_back(std::log(mode.mass / modes.front().mass) + lead);
  return said;
}

TEST(Hypotheses, OfManyEachIsJudgedInTurnByAllThatIsNew) {
  std::vector<Pose2> places;
  for (int i = 0; i < 20; ++i) places.push_back({0.6 * i, 1.0 + 0.1 * i, 2.0});
  const std::vector<double> first = saidOf(places, 1), second = saidOf(places, 2);
  const std::vector<double> all = saidOf(places, 13);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_told = first[i + 1] < -1e-9;  // from the true one by the scan
    const bool waits = i >= 3 + 4;              // behind the likeliest and those whose turn it is
    EXPECT_EQ(is_told && std::abs(second[i + 1] - first[i + 1]) > 1e-9, is_told && !waits) << i;
    const double alone = saidOf({places[i]}, 13)[1];
    EXPECT_LE(all[i + 1], 0.6 * alone) << i;  // it waits for four scans at the most
    EXPECT_GE(all[i + 1], 1.2 * alone) << i;
  }
}

TEST(Hypotheses, AllAreJudgedWhereNoneIsFarLikelierThanTheOthers) {
  std::vector<Pose2> places;
  for (int i = 0; i < 20; ++i) places.push_back({0.6 * i, 1.0 + 0.1 * i, 2.0});
  const std::vector<double> first = saidOf(places, 1, 5.0), second = saidOf(places, 2, 5.0);
  for (std::size_t i = 1; i < first.size(); ++i) {
    const bool is_told = first[i] < -1e-9;
    EXPECT_EQ(second[i] < first[i] - 1e-9, is_told) << i;
  }
}

TEST(Hypotheses, TakeWorkByThoseThatTheNextScanJudges) {
  const auto workOf = [](int others, double lead) {
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.add(kTruth, lead);
    for (int i = 0; i < others; ++i) hypotheses.add({0.6 * i, 1.0 + 0.1 * i, 2.0}, 0.0);
    return hypotheses.work();
  };
  EXPECT_EQ(Hypotheses(asymmetricWorld()).work(), 0);
  const SearchWork one = workOf(0, 0.0);
  EXPECT_GT(one, 0);
  EXPECT_EQ(workOf(19, 0.0), 20 * one);
  EXPECT_EQ(workOf(19, 10.0), 8 * one) << "one leads: the likeliest four, and four in turn";
  EXPECT_EQ(workOf(70, 0.0), 44 * one) << "no more than so many at once";
}

TEST(Hypotheses, HoldACoreThatDriftedOffAsLongAsScansFitWhereItIs) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  const Pose2 drifted = kTruth * Pose2{0.8, 0.0, 0.0}, away = kTruth * Pose2{1.6, 0.0, 0.0};
  EXPECT_TRUE(hypotheses.hold(kTruth, 0.5, kUsual));  // that is for the odds to tell
  EXPECT_TRUE(hypotheses.hold(drifted, 0.03, kUsual));
  EXPECT_FALSE(hypotheses.hold(drifted, 0.1, kUsual));
  EXPECT_TRUE(hypotheses.hold(drifted, 0.1, 0.15));
  EXPECT_FALSE(hypotheses.hold(away, 0.03, kUsual));
  EXPECT_FALSE(hypotheses.hold(kTruth * Pose2{0.0, 0.0, 0.5}, 0.03, kUsual));
}

TEST(Hypotheses, HoldACoreThatDriftedOffWhereTheirPlaceFitsHardlyBetter) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.weigh(seenAt(kTruth * Pose2{1.2, 0.0, 0.0}), News{0.0, 0.0}, kUsual);
  const double error = hypotheses.leastError();
  ASSERT_GT(error, 0.05);
  const Pose2 drifted = hypotheses.modes().front().T_map_base * Pose2{0.8, 0.0, 0.0};
  EXPECT_TRUE(hypotheses.hold(drifted, 1.5 * error, kUsual));
  EXPECT_FALSE(hypotheses.hold(drifted, 2.5 * error, kUsual));
}

TEST(Hypotheses, OnePlaceIsOneAndNowhereIsNone) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.add(kTruth * Pose2{0.1, 0.1, 0.1}, 0.0);
  hypotheses.add({kNaN, 1.0, 0.0}, 0.0);
  EXPECT_EQ(hypotheses.modes().size(), 1U);
}

TEST(Hypotheses, APlaceThatDriftedOffIsAlignedFromWhereASearchFoundIt) {
  const Pose2 drifted = kTruth * Pose2{0.4, 0.1, -0.3};  // still the same place
  for (const bool is_found : {false, true}) {
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.add(drifted, 0.0);
    if (is_found) hypotheses.addFound({{kTruth, 0.01}, {drifted, 0.2}}, 0.0);
    hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
    ASSERT_EQ(hypotheses.modes().size(), 1U);
    const Pose2 aligned = hypotheses.modes().front().T_map_base;
    EXPECT_EQ(distance(aligned, kTruth) < 0.05, is_found);
    EXPECT_EQ(hypotheses.leastError() < kUsual, is_found);
  }
}

/// Two beams hardly move a place against its odometry.
TEST(Hypotheses, APlaceIsAlignedFromWhereASearchFoundItAFewCentimetresOff) {
  const Observations seen = ToyLaser{2, -0.05, 0.05, 12.0}.observe(asymmetricWorld(), kTruth);
  for (const bool is_found : {false, true}) {
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.add(kTruth * Pose2{-0.09, 0.0, 0.0}, 0.0);
    if (is_found) hypotheses.addFound({{kTruth, 0.01}}, 0.0);
    hypotheses.weigh(seen, News{}, kUsual);
    ASSERT_EQ(hypotheses.modes().size(), 1U);
    EXPECT_EQ(distance(hypotheses.modes().front().T_map_base, kTruth) < 0.02, is_found)
        << distance(hypotheses.modes().front().T_map_base, kTruth);
  }
}

/// One that fits is where it was led to.
TEST(Hypotheses, APlaceThatAScanThatDoesNotFitLedAwayIsLookedForWhereItWasBefore) {
  const Pose2 drifted = kTruth * Pose2{0.4, 0.1, -0.3}, motion{0.1, 0.0, 0.0};
  for (const Eigen::Index occluded : {40, 0}) {
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.add(kTruth, 0.0);
    hypotheses.addFound({{drifted, 0.01}}, 0.0);
    hypotheses.weigh(occludedAt(drifted, occluded), News{}, kUsual);
    ASSERT_EQ(hypotheses.leastError() > 0.1, occluded > 0) << hypotheses.leastError();
    ASSERT_THAT(hypotheses.modes().front().T_map_base, PoseNear(drifted, 0.1, 0.05));
    hypotheses.ride(motion);
    hypotheses.weigh(seenAt(kTruth * motion), News{}, kUsual);
    const Pose2 now = hypotheses.modes().front().T_map_base;
    EXPECT_EQ(distance(now, kTruth * motion) < 0.05, occluded > 0) << distance(now, kTruth);
  }
}

/// Odds that were earned at one place do not go to another.
TEST(Hypotheses, APlaceThatBecameAnotherOneIsNotLookedForWhereItWasBefore) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  for (const double way : {0.4, 0.8}) {
    const Pose2 drifted = kTruth * Pose2{way, 0.0, 0.0};
    hypotheses.addFound({{drifted, 0.01}}, 0.0);
    hypotheses.weigh(occludedAt(drifted, 60), News{}, kUsual);
    ASSERT_GT(hypotheses.leastError(), 0.1);
    ASSERT_THAT(hypotheses.modes().front().T_map_base, PoseNear(drifted, 0.1, 0.05));
  }
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  EXPECT_GT(distance(hypotheses.modes().front().T_map_base, kTruth), 0.3);
}

/// Odds that were earned stay where odometry and the core have the robot.
TEST(Hypotheses, AnAlignmentThatLeadsAwayFromTheCoreLeadsToAPlaceOfItsOwn) {
  const Pose2 ridden = kTruth * Pose2{-0.4, 0.0, 0.0}, core = kTruth * Pose2{-0.55, 0.0, 0.0};
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addKept(ridden, TrackingOdds(true));
  hypotheses.addFound({{kTruth, 0.01}, {ridden, 0.2}}, 0.0);
  hypotheses.note(core);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  const std::vector<Mode> modes = hypotheses.modes();
  ASSERT_EQ(modes.size(), 2U);
  EXPECT_LT(distance(modes[0].T_map_base, core), 0.5);
  EXPECT_LT(distance(modes[1].T_map_base, kTruth), 0.05);
}

/// Step by step along a wall with gaps, say, while odometry and the core have the robot stand.
TEST(Hypotheses, AKnownPlaceDoesNotSlideAwayFromOdometryAndTheCore) {
  const Pose2 there = kTruth * Pose2{-0.36, 0.0, 0.0};
  const auto placeOf = [&](const Pose2& core, const Pose2& motion, double turn = 0.0) {
    Hypotheses hypotheses(asymmetricWorld());
    const Pose2 start = there * Pose2{0.0, 0.0, -turn} * between(motion, Pose2{});
    hypotheses.addKept(start, TrackingOdds(true));
    hypotheses.ride(motion);
    hypotheses.ride({0.0, 0.0, turn});
    hypotheses.note(core);
    hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
    return hypotheses.modes().front().T_map_base;
  };
  EXPECT_THAT(placeOf(there, {}), PoseNear(there, 1e-9, 1e-9));
  EXPECT_THAT(placeOf(kTruth, {}), PoseNear(kTruth, 0.05, 0.02)) << "the core went there as well";
  EXPECT_THAT(placeOf(there, {0.3, 0.0, 0.0}), PoseNear(kTruth, 0.05, 0.02)) << "wheels can slip";
  EXPECT_THAT(placeOf(there, {2.0, 0.0, 0.0}, 0.1), PoseNear(there, 1e-9, 1e-9))
      << "but not now for as far as they have rolled before";
}

/// A camera looks along an aisle, to whose end a cart comes nearer: the aisle looks as it would
/// farther on.
TEST(Hypotheses, AKnownPlaceDoesNotFollowWhatStandsInTheWay) {
  const auto aisle = hollow(*toyWorld({"####################",  //
                                       "#..................#",  //
                                       "#..................#",  //
                                       "#..................#",  //
                                       "####################"},
                                      0.05, {}, 10));
  const ToyLaser camera{61, -0.5, 0.5, 12.0};
  const Pose2 start{6.0, 1.25, 0.0};
  const auto mostOff = [&](const Pose2& told, const Pose2& motion) {
    Hypotheses hypotheses(aisle);
    hypotheses.addKept(told, tracked(1.0));
    Pose2 truth = start;
    double most = 0.0;
    for (double nearer = 0.1; nearer < 1.5; nearer += 0.1) {
      hypotheses.ride(motion);
      truth = truth * motion;
      hypotheses.note(truth);
      hypotheses.weigh(camera.observe(aisle, truth * Pose2{nearer, 0.0, 0.0}), News{}, kUsual);
      most = std::max(most, distance(hypotheses.modes().front().T_map_base, truth));
    }
    return most;
  };
  EXPECT_LT(mostOff(start, {}), 0.45);
  EXPECT_LT(mostOff(start * Pose2{-0.4, 0.0, 0.0}, {}), 0.45) << "though it slid before";
  EXPECT_LT(mostOff(start, {0.1, 0.0, 0.0}), 0.45) << "while the robot drives";
}

/// A core that turned away from it is in the same spot.
TEST(Hypotheses, AnAlignmentThatTurnsBackFromTheCoreIsOfTheSamePlace) {
  const Pose2 ridden = kTruth * Pose2{0.02, 0.0, 0.1}, core = kTruth * Pose2{0.0, 0.0, 0.4};
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addKept(ridden, TrackingOdds(true));
  hypotheses.note(core);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  ASSERT_EQ(hypotheses.modes().size(), 1U);
  EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(kTruth, 0.05, 0.02));
}

/// So many, the first ones of a grid.
std::vector<Place> placesOfGrid(int count) {
  std::vector<Place> places;
  for (int i = 0; i < count; ++i) places.push_back({{0.6 * (i % 12), 0.6 * (i / 12), 0.0}, 0.0});
  return places;
}

TEST(Hypotheses, WhatASearchAlignedIsTakenAsItIsOnce) {
  const Pose2 found = kTruth * Pose2{0.03, 0.0, 0.0};
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addAligned({{found, 0.015}}, 0.0);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(found, 1e-12, 1e-12));
  EXPECT_EQ(hypotheses.leastError(), 0.015);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(kTruth, 0.02, 0.01));
}

TEST(Hypotheses, LackPlacesThatHadNoRoomUnlessOneIsLikelierByFar) {
  Hypotheses found(asymmetricWorld()), kept(asymmetricWorld());
  found.addFound(placesOfGrid(100), 0.0);
  EXPECT_FALSE(found.lackSome());
  found.addFound(placesOfGrid(101), 0.0);
  EXPECT_TRUE(found.lackSome());
  EXPECT_EQ(found.modes().size(), 100U);
  found.addFound(placesOfGrid(50), 0.0);  // searched again
  EXPECT_FALSE(found.lackSome());
  TrackingOdds odds(true);
  odds.find();
  kept.addKept(kTruth, odds);
  kept.addFound(placesOfGrid(101), 0.0);
  EXPECT_FALSE(kept.lackSome());
  kept.addFound(placesOfGrid(101), 5.0);
  EXPECT_TRUE(kept.lackSome());
}

TEST(Hypotheses, ManyUnlikelyPlacesAreNoneOfThemRuledOutTogether) {
  constexpr auto kTogether = Hypotheses::Against::kTogether;
  for (const int others : {1, 99}) {  // 7.5 - log(99) is less than the margin, 6
    Hypotheses each(asymmetricWorld()), together(asymmetricWorld());
    for (Hypotheses* hypotheses : {&each, &together}) {
      hypotheses->add(kTruth, 7.5);
      hypotheses->addFound(placesOfGrid(others), 0.0);
    }
    each.prune();
    EXPECT_EQ(each.modes().size(), 1U);
    together.prune(kTogether);
    EXPECT_EQ(together.modes().size(), others == 1 ? 1U : 96U)
        << "but four, which weigh too little";
  }
}

TEST(Hypotheses, PlacesThatHadNoRoomCountTogether) {
  Hypotheses kept(asymmetricWorld());
  kept.add(kTruth, 7.5);
  for (const int left_out : {1, 20}) {
    kept.addFound(placesOfGrid(99 + left_out), 0.0);
    EXPECT_FALSE(kept.lackSome());
    EXPECT_EQ(kept.lackSome(Hypotheses::Against::kTogether), left_out == 20);
  }
}

TEST(Hypotheses, WordDoesNotMakeUpForPlacesThatHadNoRoom) {
  Hypotheses told(asymmetricWorld());
  told.addKept(kTruth, TrackingOdds(true));
  told.addFound(placesOfGrid(101), 0.0);
  EXPECT_TRUE(told.lackSome()) << "any of those that were left out may be the right one";
}

TEST(Hypotheses, ManyNewPlacesAreJudgedInTurnsAndNoneIsAModeBefore) {
  Hypotheses hypotheses(asymmetricWorld());
  std::vector<Place> places = placesOfGrid(99);
  places.push_back({kTruth, 0.0});
  hypotheses.addFound(places, 0.0);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  EXPECT_TRUE(hypotheses.waitForSome());
  EXPECT_EQ(hypotheses.modes().size(), 40U);
  EXPECT_EQ(massOf(hypotheses, kTruth), 0.0) << "the last one";
  int scans = 1;
  for (; hypotheses.waitForSome() && scans < 10; ++scans) {
    hypotheses.prune();
    hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  }
  EXPECT_EQ(scans, 3);
  for (; scans < 12; ++scans) {
    hypotheses.prune();
    hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  }
  hypotheses.prune();
  ASSERT_EQ(hypotheses.modes().size(), 1U);
  EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(kTruth, 0.05, 0.02));
}

TEST(Hypotheses, APlaceIsFollowedWhereOdometryDrifts) {
  Hypotheses followed(asymmetricWorld());
  followed.addKept(kTruth, TrackingOdds(true));
  Pose2 truth = kTruth, by_odometry = kTruth;
  for (int step = 0; step < 20; ++step) {
    truth = truth * Pose2{0.1, 0.0, 0.0};
    by_odometry = by_odometry * Pose2{0.13, 0.0, 0.02};
    followed.ride({0.13, 0.0, 0.02});
    followed.follow(seenAt(truth).scan, kUsual);
  }
  EXPECT_GT(distance(by_odometry, truth), 0.5) << "or there is nothing to follow";
  EXPECT_THAT(followed.modes().front().T_map_base, PoseNear(truth, 0.05, 0.03));
  EXPECT_TRUE(followed.waitForSome()) << "no scan was evidence";
}

/// What a scan, of which so much counts, takes from the odds of a kept place, and from those of one
/// that is new beside the true one.
std::pair<double, double> lostByOneScan(double share) {
  const Pose2 other{8.0, 1.3, 2.0};
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.add(other, 20.0);
  hypotheses.addKept(kWrong * Pose2{1.5, 0.0, 0.0}, TrackingOdds(true));
  const auto odds = [&](const Pose2& pose) {
    return std::log(massOf(hypotheses, pose) / massOf(hypotheses, kTruth));
  };
  hypotheses.weigh(seenAt(kTruth), News{share, share}, 0.15);
  return {TrackingOdds(true).value() - odds(kWrong * Pose2{1.5, 0.0, 0.0}), 20.0 - odds(other)};
}

TEST(Hypotheses, AScanCountsInFullForNewPlacesAndByItsShareForTheKeptOne) {
  const auto [kept_half, new_half] = lostByOneScan(0.5);
  const auto [kept_full, new_full] = lostByOneScan(1.0);
  EXPECT_GT(kept_half, 0.5);
  EXPECT_NEAR(kept_full, 2.0 * kept_half, 1e-6);
  EXPECT_GT(new_half, 0.5);
  EXPECT_NEAR(new_full, new_half, 1e-6);
}

TEST(Hypotheses, WhatASearchAlignedIsJudgedAtOnce) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addAligned(placesOfGrid(100), 0.0);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  EXPECT_FALSE(hypotheses.waitForSome());
}

/// The symmetric room with a cupboard in one half of it.
std::shared_ptr<const OccupancyGrid> roomWithCupboard() {
  const auto room = symmetricWorld();
  const Lattice& lattice = room->lattice();
  std::vector<std::int8_t> cells = room->cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell c = lattice.cell(i);
    if (c.x >= 60 && c.x < 66 && c.y >= 16 && c.y < 24) cells[i] = OccupancyGrid::kOccupied;
  }
  return std::make_shared<const OccupancyGrid>(lattice, std::move(cells));
}

const Pose2 kBeforeTheCupboard{2.3, 1.0, 0.0};  // which is not there any more
const Pose2 kTwin{3.7, 2.0, kPi};

Observations seenWithoutIt() {  // of its twin no beam comes near it
  return ToyLaser{91, -kPi / 4, kPi / 4, 12.0}.observe(symmetricWorld(), kBeforeTheCupboard);
}

TEST(Hypotheses, AKeptPlaceWhereSomethingWasMovedLosesLittleByLittle) {
  Hypotheses kept(roomWithCupboard());
  kept.addKept(kBeforeTheCupboard, tracked(1.0));  // 12 nats
  kept.add(kTwin, 0.0);
  Hypotheses other(roomWithCupboard());
  other.add(kBeforeTheCupboard, 12.0);
  other.add(kTwin, 0.0);
  for (Hypotheses* hypotheses : {&kept, &other}) {
    for (int i = 0; i < 3; ++i) hypotheses->weigh(seenWithoutIt(), News{}, kUsual);
    hypotheses->prune();
  }
  EXPECT_GT(massOf(kept, kBeforeTheCupboard), 0.99);
  EXPECT_TRUE(kept.knows(kTwin));  // which explains the scans
  EXPECT_FALSE(other.knows(kBeforeTheCupboard));
}

/// One thing may be all that a camera sees.
TEST(Hypotheses, APlaceThatWasFoundLatelyIsNotLostToOneViewOfACamera) {
  const TrackingOdds lately;
  ASSERT_FALSE(lately.isKept());
  const auto stays = [&](double half, bool was_believed) {
    const auto seen = ToyLaser{91, -half, half, 12.0}.observe(symmetricWorld(), kBeforeTheCupboard);
    Hypotheses hypotheses(roomWithCupboard());
    was_believed ? hypotheses.addKept(kBeforeTheCupboard, lately)
                 : hypotheses.add(kBeforeTheCupboard, lately.value());
    hypotheses.add(kTwin, 0.0);
    hypotheses.weigh(seen, News{}, kUsual);
    hypotheses.prune();
    EXPECT_TRUE(hypotheses.knows(kTwin));
    return hypotheses.knows(kBeforeTheCupboard);
  };
  EXPECT_TRUE(stays(0.5, true));
  EXPECT_FALSE(stays(0.5, false));
  EXPECT_FALSE(stays(0.8, true)) << "another laser";
}

TEST(Hypotheses, AKeptPlaceThatNothingFitsIsRuledOutAtOnce) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addKept(kWrong, tracked(3.0));
  hypotheses.add(kTruth, 0.0);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  hypotheses.prune();
  EXPECT_FALSE(hypotheses.knows(kWrong));
}

/// Nobody carries a robot without a scan that shows it; what somebody told was never seen.
TEST(Hypotheses, AKeptPlaceThatNothingFitsIsRuledOutByMetresWhereScansGoOn) {
  const auto stays = [](const TrackingOdds& odds, int scans) {
    News news;
    news.goes_on = true;
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.addKept(kWrong, odds);
    hypotheses.add(kTruth, 0.0);
    for (int i = 0; i < scans; ++i) hypotheses.weigh(seenAt(kTruth), news, kUsual);
    hypotheses.prune();
    return hypotheses.knows(kWrong);
  };
  EXPECT_TRUE(stays(tracked(3.0), 3));
  EXPECT_FALSE(stays(tracked(3.0), 15));
  EXPECT_FALSE(stays(TrackingOdds(true), 1)) << "told";
}

/// It is far likelier than any other place, and one of its own; from a place that was not known,
/// what is a slip away is not looked for.
TEST(Hypotheses, AKeptPlaceThatDoesNotFitIsLookedForASlipOfTheWheelsAway) {
  for (const Pose2& slip : {Pose2{-0.4, 0.7, 0.1}, {0.1, 0.0, 0.6}}) {
    Hypotheses kept(asymmetricWorld()), other(asymmetricWorld());
    kept.addKept(kTruth * slip, tracked(1.0));  // 12 nats
    other.add(kTruth * slip, 12.0);
    for (Hypotheses* hypotheses : {&kept, &other}) {
      hypotheses->add(kWrong, 7.0);
      hypotheses->weigh(seenAt(kTruth), News{}, kUsual);
      hypotheses->prune();
    }
    const auto near_truth = PoseNear(kTruth, 0.05, 0.02);
    EXPECT_THAT(kept.modes().front().T_map_base, near_truth) << slip.x;
    EXPECT_GT(kept.modes().front().mass, 0.99) << slip.x;
    EXPECT_THAT(other.modes().front().T_map_base, testing::Not(near_truth)) << slip.x;
  }
}

/// In a turn, less than a place away: it is the same one, and there, though an alignment does not
/// lead there. What is only beside it may fit as a thing was moved.
TEST(Hypotheses, AKeptPlaceIsWhereWheelsSlippedToInATurnThoughThatIsTheSamePlace) {
  const auto keptAfter = [](const Pose2& slip, bool is_known) {
    Hypotheses hypotheses(asymmetricWorld());
    is_known ? hypotheses.addKept(kTruth * slip, tracked(1.0))
             : hypotheses.add(kTruth * slip, 12.0);
    hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
    EXPECT_EQ(hypotheses.modes().size(), 1U);
    return hypotheses.modes().front().T_map_base;
  };
  const auto near_truth = PoseNear(kTruth, 0.05, 0.02);
  for (const Pose2& slip : {Pose2{0.2, 0.2, -0.3}, {0.25, 0.0, 0.34}, {0.0, 0.0, -0.34}}) {
    EXPECT_THAT(keptAfter(slip, true), near_truth) << slip.theta;
    EXPECT_THAT(keptAfter(slip, false), testing::Not(near_truth)) << slip.theta;
  }
  const Pose2 beside{0.2, 0.15, -0.24};
  EXPECT_THAT(keptAfter(beside, true), testing::Not(near_truth));
}

TEST(Hypotheses, TakeMoreWorkAfterAScanForWhichASlipWasLookedFor) {
  const auto workAfter = [](const Pose2& kept) {
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.addKept(kept, tracked(1.0));
    hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
    const SearchWork work = hypotheses.work();
    hypotheses.clear();
    EXPECT_EQ(hypotheses.work(), 0);
    return work;
  };
  EXPECT_GT(workAfter(kWrong), 10 * workAfter(kTruth));
}

/// Most hits are on walls there, too: the place is the same, and the core is right within it.
TEST(Hypotheses, AlongAWallAKeptPlaceIsNotLostAndACoreThatSeesTheSlipIsHeld) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addKept(kTruth * Pose2{0.8, 0.0, 0.0}, tracked(1.0));  // 12 nats
  hypotheses.add(kWrong, 7.0);
  for (int scan = 0; scan < 10; ++scan) {
    hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
    hypotheses.prune();
    EXPECT_TRUE(hypotheses.hold(kTruth, 0.01, kUsual)) << scan;
  }
  ASSERT_EQ(hypotheses.modes().size(), 1U);
  EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(kTruth, 0.5, 0.02));
}

/// A core that follows the robot over a slip in a turn is right, and not in a place that looks
/// alike.
TEST(Hypotheses, APlaceThatIsASlipAwayFromAKeptOneIsAsLikelyWhoeverFoundIt) {
  const Pose2 truth{2.0, 1.0, 0.3}, twin{4.0, 2.0, wrapAngle(0.3 + kPi)};
  const auto seen = ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(symmetricWorld(), truth);
  for (const double turn : {0.6, -0.9}) {
    Hypotheses hypotheses(symmetricWorld());
    hypotheses.addKept(truth * Pose2{0.0, 0.0, turn}, tracked(1.0));  // 12 nats
    hypotheses.add(truth, 0.0);
    hypotheses.add(twin, 0.0);
    hypotheses.weigh(seen, News{}, kUsual);
    hypotheses.prune();
    ASSERT_EQ(hypotheses.modes().size(), 2U) << "no scan told them apart: " << turn;
    EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(truth, 0.05, 0.02)) << turn;
    EXPECT_GT(hypotheses.modes().front().mass, 0.99) << turn;
  }
}

/// They slip for some scans on end.
TEST(Hypotheses, WheelsThatSlippedMaySlipAgain) {
  Hypotheses hypotheses(asymmetricWorld());
  Pose2 truth = kTruth;
  hypotheses.addKept(truth, tracked(1.0));  // 12 nats
  hypotheses.add(kWrong, 0.0);
  for (int slips = 1; slips <= 2; ++slips) {
    truth = truth * Pose2{0.0, 0.0, 0.1};
    hypotheses.ride({0.0, 0.0, 0.6});
    hypotheses.weigh(seenAt(truth), News{}, kUsual);
    hypotheses.prune();
    EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(truth, 0.05, 0.02)) << slips;
  }
  truth = truth * Pose2{0.0, 0.0, -0.2};
  hypotheses.ride({0.0, 0.0, -0.2});
  hypotheses.add(kWrong, 0.0);
  hypotheses.weigh(seenAt(truth), News{}, kUsual);
  EXPECT_GT(massOf(hypotheses, truth), 0.99);
}

/// It fits far worse, so little of what it is likelier by may be left soon.
TEST(Hypotheses, WhereWheelsCanHaveSlippedToIsNotRuledOutByWhatFitsFarWorse) {
  const Pose2 core = kTruth * Pose2{0.0, 0.0, 0.05}, kept = kTruth * Pose2{0.0, 0.0, 0.9};
  for (const bool is_known : {true, false}) {
    Hypotheses hypotheses(asymmetricWorld());
    is_known ? hypotheses.addKept(kept, tracked(1.0)) : hypotheses.add(kept, 12.0);
    hypotheses.weigh(seenAt(kept), News{}, kUsual);
    hypotheses.addCore(core, 0.0);
    hypotheses.weigh(seenAt(kTruth), News{0.01, 0.01}, kUsual);
    hypotheses.prune();
    EXPECT_EQ(hypotheses.knows(kTruth), is_known);
  }
}

/// By odometry alone: where a scan aligns it may be farther off.
TEST(Hypotheses, TellWhichPlaceThatWasKnownCanBeSomewhere) {
  const Pose2 start = kTruth * Pose2{-0.1, 0.0, 0.0}, slip = kTruth * Pose2{0.0, 0.0, -0.6};
  const auto around = [](const Pose2& pose) {
    Leeway leeway;
    leeway.note({pose, Eigen::Matrix3d::Zero(), {}}, true);
    return leeway;
  };
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kWrong, 0.0);
  hypotheses.addKept(start, tracked(1.0));
  hypotheses.addCore(slip, 0.0);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  Hypothesis* known = hypotheses.knownWithin(around(start));
  ASSERT_NE(known, nullptr);
  EXPECT_TRUE(known->was_believed);
  EXPECT_THAT(known->T_map_ridden, PoseNear(start, 1e-9, 1e-9));
  EXPECT_THAT(known->T_map_base, PoseNear(kTruth, 0.03, 0.03));
  ASSERT_NE(hypotheses.knownWithin(around(slip)), nullptr);
  EXPECT_TRUE(hypotheses.knownWithin(around(slip))->has_slipped);
  EXPECT_EQ(hypotheses.knownWithin(around(kWrong)), nullptr) << "nobody believed in it";
  hypotheses.ride({1.0, 0.0, 0.0});
  hypotheses.weigh({}, News{}, kUsual);  // other senses alone
  EXPECT_NE(hypotheses.knownWithin(around(kTruth * Pose2{1.0, 0.0, 0.0})), nullptr);
}

TEST(Hypotheses, ACoreASlipAwayFromAKeptPlaceIsLikelierThanOneElsewhere) {
  const Pose2 near = kTruth * Pose2{0.5, 0.0, -0.6}, far = kTruth * Pose2{1.1, 0.0, 0.0};
  const Pose2 turned = kTruth * Pose2{0.0, 0.0, 1.1};
  for (const Pose2& core : {near, far, turned, kTruth}) {
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.addCore(core, 0.0);
    EXPECT_TRUE(hypotheses.isEmpty()) << "nothing to compare it with";
    hypotheses.addKept(kTruth, tracked(1.0));  // 12 nats
    hypotheses.addCore(core, 0.0);
    const double odds = std::exp(distance(core, near) == 0.0 ? -4.0 : -12.0);
    const double mass = distance(core, kTruth) == 0.0 && core.theta == kTruth.theta ? 0.0 : odds;
    EXPECT_NEAR(hypotheses.modes().front().mass, 1.0 / (1.0 + mass), 1e-9);
  }
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 12.0);  // nobody believed in it
  hypotheses.addCore(near, 0.0);
  EXPECT_LT(hypotheses.modes().back().mass, 1e-5);
}

/// As in an aisle, every place of which looks like a hundred others.
TEST(Hypotheses, WhereACoreSlippedToThereIsRoomHoweverManyPlacesWereFound) {
  const Pose2 truth = kTruth * Pose2{0.0, 0.0, -0.6};
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addKept(kTruth, tracked(1.0));  // 12 nats
  hypotheses.addFound(placesOfGrid(150), 0.0);
  ASSERT_EQ(hypotheses.modes().size(), 100U) << "no more of them";
  hypotheses.addCore(truth, 0.0);
  ASSERT_TRUE(hypotheses.knows(truth));
  hypotheses.weigh(seenAt(truth), News{}, kUsual);
  hypotheses.prune();
  EXPECT_GT(massOf(hypotheses, truth), 0.9);
  Hypotheses full(asymmetricWorld());
  full.addKept(kTruth, tracked(1.0));
  for (int i = 0; i < 200; ++i) full.addCore({100.0 + i, 0.0, 0.0}, 0.0);
  EXPECT_EQ(full.modes().size(), 120U) << "there is an end to it";
}

/// Then odds that were earned may speak for the known place for long: what looks as if something
/// was moved rules it out little by little.
TEST(Hypotheses, TellThatOnlyASlipFits) {
  const Pose2 truth = kTruth * Pose2{0.0, 0.0, -0.6}, off = kTruth * Pose2{0.0, 0.0, 0.6};
  Hypotheses hypotheses(asymmetricWorld());
  EXPECT_FALSE(hypotheses.fitOnlySlip(truth)) << "there is none";
  hypotheses.addKept(kTruth, tracked(1.0));
  hypotheses.addCore(truth, 0.0);
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  EXPECT_FALSE(hypotheses.fitOnlySlip(truth)) << "it does not";
  hypotheses.weigh(seenAt(truth), News{0.01, 0.01}, kUsual);
  EXPECT_TRUE(hypotheses.fitOnlySlip(truth));
  EXPECT_FALSE(hypotheses.fitOnlySlip(kTruth)) << "nobody slipped there";
  EXPECT_FALSE(hypotheses.fitOnlySlip(off));
  hypotheses.weigh(seenAt(kWrong), News{0.01, 0.01}, kUsual);
  EXPECT_FALSE(hypotheses.fitOnlySlip(truth)) << "nothing fits";
}

/// Some hits that are off the walls are a small error of all beams.
TEST(Hypotheses, ASlipIsLookedForWhereFewBeamsHit) {
  const Pose2 truth{1.5, 3.2, kPi};  // before a wall, with a laser that sees little more
  const auto seen = ToyLaser{91, -kPi / 2, kPi / 2, 1.1}.observe(asymmetricWorld(), truth);
  ASSERT_LT(seen.scan.hits(), 30);
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addKept(truth * Pose2{0.0, 0.0, 0.9}, tracked(1.0));
  hypotheses.weigh(seen, News{}, kUsual);
  const std::vector<Mode> modes = hypotheses.modes();
  const bool is_found = std::any_of(modes.begin(), modes.end(), [&](const Mode& mode) {
    return std::abs(wrapAngle(mode.T_map_base.theta - truth.theta)) < 0.1;
  });
  EXPECT_TRUE(is_found);
}

TEST(Hypotheses, WordRulesOutNoTwinButTrackingDoes) {
  const auto seen =
      ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(symmetricWorld(), kBeforeTheCupboard);
  for (const bool is_word : {true, false}) {
    Hypotheses hypotheses(symmetricWorld());
    hypotheses.addKept(kBeforeTheCupboard, is_word ? TrackingOdds(true) : tracked(0.0));
    hypotheses.add(kTwin, 0.0);
    hypotheses.weigh(seen, News{}, kUsual);
    hypotheses.prune();
    EXPECT_EQ(hypotheses.knows(kTwin), is_word);
    EXPECT_EQ(hypotheses.isByWord(), is_word);
  }
}

TEST(Hypotheses, APlaceThatComesLateHasNoAdvantage) {
  Hypotheses hypotheses(roomWithCupboard());
  const TrackingOdds odds = tracked(1.0);
  EXPECT_DOUBLE_EQ(hypotheses.entry(3.0, odds), -3.0);
  hypotheses.addKept(kBeforeTheCupboard, odds);
  EXPECT_DOUBLE_EQ(hypotheses.entry(3.0, odds), 0.0);
  hypotheses.add(kTwin, 0.0);
  for (int i = 0; i < 3; ++i) hypotheses.weigh(seenWithoutIt(), News{}, kUsual);
  EXPECT_NEAR(hypotheses.entry(3.0, odds), -0.6, 1e-9);  // what the kept one has lost
}

/// Turning on the spot shows the same furniture again and again.
TEST(Hypotheses, AKeptPlaceLosesOnlyByWhatIsSeenAnew) {
  Hypotheses hypotheses(roomWithCupboard());
  hypotheses.addKept(kBeforeTheCupboard, tracked(1.0));
  hypotheses.add(kTwin, 0.0);
  for (int i = 0; i < 10; ++i) hypotheses.weigh(seenWithoutIt(), News{0.5, 0.05}, kUsual);
  EXPECT_NEAR(hypotheses.entry(3.0, tracked(1.0)), -0.1, 1e-9);
}

/// Whether something is there that should not be does not matter where the robot is elsewhere.
TEST(Hypotheses, AKeptPlaceThatIsRefutedIsLostOnTheSpot) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.addKept(kWrong, tracked(1.0));
  hypotheses.add(kTruth, 0.0);
  hypotheses.weigh(seenAt(kTruth), News{1.0, 0.0}, kUsual);
  EXPECT_LT(massOf(hypotheses, kWrong), 0.01);
}

/// A robot that drove on while it was lost: its place has less left to lose.
TEST(Hypotheses, WhatAKeptPlaceHasLostCountsAsLongAsItsOddsAreLeft) {
  Hypotheses hypotheses(roomWithCupboard());
  TrackingOdds odds = tracked(1.0);  // 12 nats
  hypotheses.addKept(kBeforeTheCupboard, odds);
  hypotheses.add(kTwin, 0.0);
  for (int i = 0; i < 3; ++i) hypotheses.weigh(seenWithoutIt(), News{}, kUsual);
  EXPECT_NEAR(hypotheses.entry(3.0, odds), -0.6, 1e-9);
  odds.loseWay(Pose2{0.2, 0.0, 0.0});
  EXPECT_NEAR(hypotheses.entry(3.0, odds), -0.4, 1e-9);
  odds.loseWay(Pose2{1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(hypotheses.entry(3.0, odds), 0.0);
}

/// As where a wall is missing on the map: another place would show through walls.
TEST(Hypotheses, AKeptPlaceWhereSomethingWasBroughtLosesLeast) {
  const auto seen =
      ToyLaser{91, -kPi / 4, kPi / 4, 12.0}.observe(roomWithCupboard(), kBeforeTheCupboard);
  Hypotheses hypotheses(roomWithCupboard());
  hypotheses.addKept(kTwin, tracked(1.0));
  hypotheses.add(kBeforeTheCupboard, 0.0);
  for (int i = 0; i < 3; ++i) hypotheses.weigh(seen, News{}, kUsual);
  EXPECT_NEAR(hypotheses.entry(3.0, tracked(1.0)), -0.6, 1e-9);  // what the kept one has lost
  hypotheses.prune();
  EXPECT_GT(massOf(hypotheses, kTwin), 0.99);
  EXPECT_TRUE(hypotheses.knows(kBeforeTheCupboard));
}

TEST(Hypotheses, TellsThatACoreIsBesideItsPlace) {
  Hypotheses hypotheses(asymmetricWorld());
  hypotheses.add(kTruth, 0.0);
  hypotheses.note(kTruth * Pose2{0.05, 0.0, 0.01});
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  EXPECT_FALSE(hypotheses.isCoreBeside());
  hypotheses.note(kTruth * Pose2{0.25, 0.15, 0.2});
  hypotheses.weigh(seenAt(kTruth), News{}, kUsual);
  EXPECT_TRUE(hypotheses.isCoreBeside());
  EXPECT_THAT(hypotheses.modes().front().T_map_base, PoseNear(kTruth, 0.05, 0.02));
}

/// By odds alone nobody is: the likeliest place must fit far better.
TEST(Hypotheses, ACoreIsOutdoneByAPlaceThatIsLikelierAndFitsFarBetter) {
  const Pose2 beside = kTruth * Pose2{1.0, 0.4, 0.3};
  for (const double ahead : {2.0, 20.0}) {
    Hypotheses hypotheses(asymmetricWorld());
    hypotheses.add(kTruth, ahead);
    hypotheses.add(beside, 0.0);
    hypotheses.weigh(seenAt(kTruth), News{0.0, 0.0}, 0.5);  // much is usual, so little is said
    EXPECT_FALSE(hypotheses.isOutdone(kTruth));
    EXPECT_EQ(hypotheses.isOutdone(beside), ahead > 6.0);
    EXPECT_FALSE(hypotheses.isOutdone({7.5, 4.1, 2.0})) << "no place of these";
  }
  Hypotheses twins(symmetricWorld());
  const Pose2 place{1.0, 0.7, 0.4};
  const Pose2 twin{6.0 - place.x, 3.0 - place.y, wrapAngle(place.theta + kPi)};
  twins.add(place, 20.0);
  twins.add(twin, 0.0);
  twins.weigh(ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(symmetricWorld(), place),
              News{0.0, 0.0}, kUsual);
  EXPECT_FALSE(twins.isOutdone(twin));
}

TEST(Hypotheses, TellHowManyOtherPlacesLookTheSame) {
  const Pose2 truth{1.0, 1.0, 0.0}, twin{5.0, 2.0, kPi};
  const Observations seen = ToyLaser{91, -kPi / 2, kPi / 2, 12.0}.observe(symmetricWorld(), truth);
  for (const Pose2& other : {twin, Pose2{4.0, 1.0, 1.0}}) {
    Hypotheses hypotheses(symmetricWorld());
    hypotheses.add(truth, 0.0);
    hypotheses.add(other, 0.0);
    hypotheses.weigh(seen, News{}, kUsual);
    EXPECT_EQ(hypotheses.alike(truth), areSamePlace(other, twin) ? 1 : 0);
  }
}

}  // namespace
}  // namespace adaptive_localization
