// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/recovery.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <vector>

#include "ser/places.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr double kWay = 0.3;  // after which a scan is new evidence, m

Ground groundOf(const std::shared_ptr<const OccupancyGrid>& map) {
  Ground ground(map);
  ground.places =
      std::make_shared<Places>(map, ground.field, EnergyGridOptions{}, GlobalSearchOptions{});
  return ground;
}

/// Recovery in a world, told of a core that believes what the test says.
struct Watched {
  explicit Watched(std::shared_ptr<const OccupancyGrid> world)
      : map(std::move(world)), ground(groundOf(map)), recovery(ConfidenceOptions{}, ground) {}

  Places& places() { return *ground.places; }

  void tell(const Pose2& pose) {
    recovery.reset(Gaussian2{pose, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()});
    believed = pose;
  }

  void see(const Pose2& truth, const Pose2& core, const Pose2& motion = {}) {
    observe(laser.observe(map, truth), core, motion);
  }

  void observe(const Observations& seen, const Pose2& core, const Pose2& motion = {},
               const Eigen::Matrix3d& covariance = 1e-3 * Eigen::Matrix3d::Identity()) {
    recovery.ride(motion);
    recovery.observe(motion, believed * motion, {core, covariance, {{core, covariance, 1.0}}},
                     seen);
    believed = core;
  }

  /// Tracked truly for some metres.
  void track(Pose2& truth, double metres) {
    for (double way = 0.0; way < metres; way += 0.1) {
      const Pose2 motion{0.1, 0.0, 0.0};
      truth = truth * motion;
      see(truth, truth, motion);
      ASSERT_EQ(recovery.status(), Status::kTracking);
    }
  }

  double shareOf(const Pose2& pose) const {
    for (const Mode& mode : recovery.modes()) {
      if (distance(mode.T_map_base, pose) < 0.3) return mode.mass;
    }
    return 0.0;
  }

  std::shared_ptr<const OccupancyGrid> map;
  Ground ground;
  Recovery recovery;
  ToyLaser laser{91, -kPi / 2, kPi / 2, 12.0};
  Pose2 believed;
};

/// Share of the hits that are where nothing is, or, of a factor above 1, behind walls.
Observations withBystanders(Observations seen, int one_in, float factor = 0.5F) {
  for (Eigen::Index i = 0; i < seen.scan.range.size(); i += one_in) {
    for (Eigen::ArrayXf* lengths : {&seen.scan.x, &seen.scan.y, &seen.scan.range}) {
      (*lengths)[i] *= factor;
    }
  }
  return seen;
}

/// Half a turn about the middle of symmetricWorld().
Pose2 twinOf(const Pose2& pose) {
  return {6.0 - pose.x, 3.0 - pose.y, wrapAngle(pose.theta + kPi)};
}

TEST(Recovery, ATrueInitialPoseIsTrackedFromTheFirstScanOn) {
  Watched watched(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  watched.tell(truth);
  EXPECT_EQ(watched.recovery.status(), Status::kGlobalizing);  // nothing was seen yet
  watched.see(truth, truth);
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
  EXPECT_TRUE(watched.recovery.modes().empty());
}

TEST(Recovery, AWrongInitialPoseIsLeftWhereAnotherPlaceExplainsTheScan) {
  Watched watched(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  watched.tell({8.0, 1.0, 2.0});
  for (int scan = 0; scan < 2; ++scan) {
    EXPECT_FALSE(watched.recovery.mustMove());
    watched.see(truth, watched.believed);
    EXPECT_NE(watched.recovery.status(), Status::kTracking);
  }
  ASSERT_TRUE(watched.recovery.mustMove());
  ASSERT_EQ(watched.recovery.modes().size(), 1U);
  EXPECT_THAT(watched.recovery.modes().front().T_map_base, PoseNear(truth, 0.1, 0.05));
}

TEST(Recovery, FromAnywhereOneScanWillDoWhereNothingLooksAlike) {
  Watched watched(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  watched.recovery.reset(Anywhere{});
  EXPECT_EQ(watched.recovery.status(), Status::kGlobalizing);
  watched.believed = truth;
  watched.see(truth, truth);
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
}

/// Until it is known where else the scan fits, one that saw the change is lost; to one that did
/// not, the scan is only odd.
TEST(Recovery, OneThatSeesThatItIsCarriedKnowsNothingOfItsPlace) {
  const Pose2 there{2.0, 3.0, -0.5};
  for (const bool sees : {true, false}) {
    SCOPED_TRACE(sees);
    Watched watched(asymmetricWorld());
    Pose2 truth{1.0, 1.0, 0.0};
    watched.tell(truth);
    watched.track(truth, 3.0);
    const auto glance = [&](const Pose2& pose) {
      const Scan scan = watched.laser.observe(watched.map, pose).scan;
      return sees && watched.recovery.seesCarrying({}, scan);
    };
    ASSERT_FALSE(glance(truth));
    ASSERT_EQ(glance(there), sees);
    watched.places().beginUpdate({}, 1);  // too little to search with
    watched.see(there, truth);
    EXPECT_EQ(watched.recovery.status(), sees ? Status::kLost : Status::kAmbiguous);
    EXPECT_LE(watched.recovery.confidence(truth, truth), sees ? 0.5 : 1.0);
    watched.places().beginUpdate({}, kUnlimitedWork);
    for (int i = 0; i < 2; ++i) watched.see(there, truth);
    EXPECT_TRUE(watched.recovery.mustMove());
  }
}

/// Somebody may have stood before the laser: what fits on is tracked on.
TEST(Recovery, OneThatSeesAChangeButFitsOnIsTrackedOnOnceOthersWereCompared) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.track(truth, 3.0);
  const auto scanFrom = [&](const Pose2& pose) {
    return watched.laser.observe(watched.map, pose).scan;
  };
  watched.recovery.seesCarrying({}, scanFrom(truth));
  ASSERT_TRUE(watched.recovery.seesCarrying({}, scanFrom({2.0, 3.0, -0.5})));
  watched.see(truth, truth);
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
  EXPECT_FALSE(watched.recovery.mustMove());
}

TEST(Recovery, AScanThatFitsFarWorseThanTheLastIsWorthAnUpdateOnce) {
  Watched watched(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  const Pose2 pushed = truth * Pose2{0.3, 0.1, 0.0};
  watched.recovery.reset(Anywhere{});
  watched.see(truth, truth);
  const Scan same = watched.laser.observe(watched.map, truth).scan;
  const Scan other = watched.laser.observe(watched.map, pushed).scan;
  EXPECT_FALSE(watched.recovery.isContradicted(truth, same));
  EXPECT_TRUE(watched.recovery.isContradicted(truth, other));
  watched.see(pushed, truth);
  EXPECT_FALSE(watched.recovery.isContradicted(truth, other)) << "this one is known";
  EXPECT_FALSE(watched.recovery.isContradicted(truth, Scan{}));
  Watched told(asymmetricWorld());
  told.tell(truth);
  told.see(truth, truth);
  told.recovery.seesCarrying({}, same);
  EXPECT_FALSE(told.recovery.isContradicted(truth, other)) << "the next update is soon enough";
  told.recovery.seesCarrying({}, same);
  EXPECT_TRUE(told.recovery.isContradicted(truth, other)) << "there may be none";
}

TEST(Recovery, ATrackedPoseIsMostlyRightWhereSomeOfTheScanDoesNotFit) {
  const Pose2 truth{2.0, 3.0, -0.5};
  std::vector<double> told;
  for (const int one_in : {1000, 3}) {
    Watched watched(asymmetricWorld());
    watched.tell(truth);
    watched.observe(withBystanders(watched.laser.observe(watched.map, truth), one_in), truth);
    ASSERT_EQ(watched.recovery.status(), Status::kTracking);
    told.push_back(watched.recovery.confidence(truth, truth));
  }
  EXPECT_GT(told[0], 0.98);
  EXPECT_LT(told[1], told[0] - 0.01);
  EXPECT_GT(told[1], 0.9);
}

TEST(Recovery, OneOfTwoPlacesIsWhereTheRobotIsEverySecondTime) {
  Watched watched(symmetricWorld());
  const Pose2 truth{2.3, 1.0, 0.0};
  watched.recovery.reset(Anywhere{});
  watched.believed = truth;
  watched.see(truth, truth);
  ASSERT_EQ(watched.recovery.status(), Status::kAmbiguous);
  EXPECT_NEAR(watched.recovery.confidence(truth, truth), 0.53, 0.02);
  EXPECT_LT(watched.recovery.confidence(twinOf(truth), truth), 0.55);
}

TEST(Recovery, PlacesThatLookTheSameNeverDriftApart) {
  Watched watched(symmetricWorld());
  watched.recovery.reset(Anywhere{});
  Pose2 truth{2.3, 1.0, 0.0};
  watched.believed = truth;
  for (int i = 0; i < 60; ++i) {
    const Pose2 motion{i % 12 < 6 ? 0.2 : -0.2, 0.0, i % 2 ? 0.05 : -0.05};
    truth = truth * motion;
    watched.see(truth, truth, motion);  // the core believes in one of them only
    ASSERT_EQ(watched.recovery.status(), Status::kAmbiguous) << i;
    ASSERT_EQ(watched.recovery.modes().size(), 2U) << i;
    EXPECT_NEAR(watched.shareOf(truth), 0.5, 0.05) << i;
    EXPECT_NEAR(watched.shareOf(twinOf(truth)), 0.5, 0.05) << i;
  }
}

TEST(Recovery, SomebodysWordHoldsAgainstATwin) {
  Watched watched(symmetricWorld());
  Pose2 truth{2.3, 1.0, 0.0};
  watched.tell(truth);
  for (int i = 0; i < 20; ++i) {
    const Pose2 motion{i % 12 < 6 ? 0.2 : -0.2, 0.0, 0.0};
    truth = truth * motion;
    watched.see(truth, truth, motion);
    ASSERT_FALSE(watched.recovery.mustMove()) << i;
    const bool is_fresh = i == 0;  // later it is odd that no scan has told
    ASSERT_EQ(watched.recovery.status(), is_fresh ? Status::kTracking : Status::kAmbiguous) << i;
    ASSERT_GT(watched.shareOf(truth), 0.99) << i;
  }
}

TEST(Recovery, ACoreThatSlippedGoesBackToItsPlace) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.track(truth, 2.0);
  const Pose2 slip{0.2, 0.15, 0.17};  // still of the same place
  watched.see(truth, truth * slip, slip);
  EXPECT_NE(watched.recovery.status(), Status::kTracking);
  double way = 0.0;  // what one place shows may be furniture that was moved
  while (way < 1.2 && !watched.recovery.mustMove()) {
    const Pose2 motion{0.1, 0.0, 0.0};
    way += 0.1;
    truth = truth * motion;
    watched.see(truth, truth * slip, motion);
    EXPECT_NE(watched.recovery.status(), Status::kTracking) << way;
  }
  EXPECT_GT(way, 0.65);
  ASSERT_TRUE(watched.recovery.mustMove());
  EXPECT_THAT(watched.recovery.modes().front().T_map_base, PoseNear(truth, 0.05, 0.03));
  watched.see(truth, truth);
  EXPECT_FALSE(watched.recovery.mustMove());
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
}

/// Odometry has it where it cannot be, and to a short-sighted laser many places look alike, of
/// which one is a slip away.
TEST(Recovery, AfterASlipThePoseIsWhereTheCoreHasItThoughOtherPlacesLookAlike) {
  Watched watched(asymmetricWorld());
  Pose2 truth{3.4, 3.2, kPi};
  watched.tell(truth);
  watched.track(truth, 2.0);
  watched.laser.max_range = 1.1;  // m, it sees no more than a wall before it
  Pose2 by_odometry = truth;
  for (int i = 0; i < 4; ++i) {
    const Pose2 motion{0.0, 0.0, 0.8};  // of the wheels
    by_odometry = truth * motion;
    truth = truth * Pose2{0.0, 0.0, i % 2 == 0 ? 0.1 : -0.1};
    watched.see(truth, truth, motion);
  }
  ASSERT_EQ(watched.recovery.status(), Status::kAmbiguous);
  ASSERT_LT(watched.shareOf(truth), 0.95);
  const auto publishedFor = [&](const Pose2& core) {
    return watched.recovery.published(by_odometry, {core, 1e-3 * Eigen::Matrix3d::Identity(), {}});
  };
  EXPECT_THAT(publishedFor(truth), PoseNear(truth, 1e-9, 1e-9));
  EXPECT_THAT(publishedFor({8.0, 1.0, 0.0}), PoseNear(by_odometry, 1e-9, 1e-9));
}

/// No other place is left, and the status is ambiguous for another reason: the cloud has two parts.
TEST(Recovery, AfterASlipThePoseIsWhereTheCoreHasItWhereThatIsTheOnlyPlace) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.track(truth, 2.0);
  const Eigen::Matrix3d covariance = 1e-3 * Eigen::Matrix3d::Identity();
  const Estimate core{
      truth, covariance, {{truth, covariance, 0.8}, {{8.0, 1.0, 0.0}, covariance, 0.2}}};
  watched.recovery.observe({}, truth, core, watched.laser.observe(watched.map, truth));
  ASSERT_EQ(watched.recovery.status(), Status::kAmbiguous);
  ASSERT_TRUE(watched.recovery.modes().empty());
  const Pose2 slip{0.1, 0.0, 0.7}, jump{1.5, 0.0, 0.0};
  EXPECT_THAT(watched.recovery.published(truth * slip, core), PoseNear(truth, 1e-9, 1e-9));
  EXPECT_THAT(watched.recovery.published(truth * jump, core), PoseNear(truth * jump, 1e-9, 1e-9));
}

TEST(Recovery, ACarriedRobotIsFoundAtTheSecondScan) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.track(truth, 2.0);
  const Pose2 after{2.0, 3.0, -0.5};
  watched.see(after, watched.believed);
  EXPECT_FALSE(watched.recovery.mustMove());
  watched.see(after, watched.believed);
  ASSERT_TRUE(watched.recovery.mustMove());
  EXPECT_THAT(watched.recovery.modes().front().T_map_base, PoseNear(after, 0.1, 0.05));
  Pose2 on = after;
  for (int i = 0; i < 3; ++i) {  // the core goes there, and the robot turns
    const Pose2 motion{0.0, 0.0, i == 0 ? 0.0 : kWay};
    on = on * motion;
    watched.see(on, on, motion);
  }
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
}

TEST(Recovery, APlaceThatTheCoreLeftStaysInTheRace) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.track(truth, 2.0);
  const Pose2 wrong{7.5, 4.1, 2.0};
  watched.see(truth, wrong);  // the core jumps for no reason
  EXPECT_NE(watched.recovery.status(), Status::kTracking);
  EXPECT_GT(watched.shareOf(truth), 0.99);
  watched.see(truth, wrong);
  EXPECT_TRUE(watched.recovery.mustMove());
}

/// Of a laser that something covers.
Observations coveredScan() {
  std::vector<Eigen::Vector2d> cover;
  for (int i = -80; i <= 80; ++i) {
    const double range = 0.25 + 0.1 * (i % 3);
    cover.emplace_back(range * std::cos(0.0175 * i), range * std::sin(0.0175 * i));
  }
  Observations covered = hitsAt(cover, 12.0);
  covered.scan.view.start = -kPi / 2;
  covered.scan.view.width = kPi;
  return covered;
}

/// All that a camera sees of a wall may be within arm's length. That is no hand before it: the
/// robot turns there for as long as it likes, and is as known as before.
TEST(Recovery, ARobotCloseToAWallIsNotCovered) {
  Watched watched(asymmetricWorld());
  Pose2 truth{3.0, 3.2, kPi};
  watched.tell(truth);
  watched.track(truth, 2.0);
  ASSERT_NEAR(truth.x, 1.0, 0.11);  // the wall is at 0.5 m
  watched.laser = {61, -0.5, 0.5, 12.0};
  for (int i = 0; i < 40; ++i) {
    const Pose2 motion{0.0, 0.0, i % 2 == 0 ? 0.1 : -0.1};
    truth = truth * motion;
    watched.see(truth, truth, motion);
    ASSERT_EQ(watched.recovery.status(), Status::kTracking) << i;
    ASSERT_GT(watched.recovery.confidence(truth, truth), 0.9) << i;
  }
  const Observations seen = watched.laser.observe(watched.map, truth);
  EXPECT_EQ(watched.recovery.evidenceOf(truth, seen.scan).hits(), seen.scan.hits());
  const Observations hand = withBystanders(seen, 1, 0.3F);
  EXPECT_EQ(watched.recovery.evidenceOf(truth, hand.scan).hits(), 0);
}

TEST(Recovery, ACoveredLaserIsNoReasonToMoveAndTheSameViewSettlesIt) {
  Watched watched(asymmetricWorld());
  Pose2 truth{2.0, 3.0, -0.5};
  watched.tell(truth);
  watched.see(truth, truth);
  const Observations covered = coveredScan();
  EXPECT_EQ(watched.recovery.evidenceOf(truth, covered.scan).hits(), 0);
  for (int i = 0; i < 10; ++i) {
    watched.observe(covered, truth);
    EXPECT_FALSE(watched.recovery.mustMove()) << i;
  }
  EXPECT_EQ(watched.recovery.status(), Status::kLost);
  const Pose2 motion{kWay, 0.0, 0.0};
  watched.see(truth * motion, truth * motion, motion);
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
}

/// A laser that reaches so far sees nothing but a stray hit.
Observations nothingWithin(double max_range) {
  Observations nothing = hitsAt({{0.3, 0.0}}, max_range);
  nothing.scan.no_return_bearing =
      Eigen::ArrayXf::LinSpaced(90, static_cast<float>(-kPi / 2), static_cast<float>(kPi / 2));
  return nothing;
}

TEST(Recovery, AViewIntoTheOpenIsAsGoodAsAnyAndOneWithoutTheMapsWallsIsNot) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.track(truth, 3.0);  // to where no wall is within 0.4 m
  const Observations open = nothingWithin(0.4), blind = nothingWithin(12.0);
  const double way = 0.02;
  for (int i = 0; i < 20; ++i) {
    truth = truth * Pose2{way, 0.0, 0.0};
    EXPECT_EQ(watched.recovery.evidenceOf(truth, open.scan).hits(), 0);
    EXPECT_FALSE(watched.recovery.isContradicted(truth, open.scan));
    watched.observe(open, truth, {way, 0.0, 0.0});
    EXPECT_EQ(watched.recovery.status(), Status::kTracking) << i;
  }
  watched.see(truth, truth);  // what was known of the place is known still
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
  EXPECT_TRUE(watched.recovery.isContradicted(truth, blind.scan));
  for (int i = 0; i < 2; ++i) watched.observe(blind, truth);
  EXPECT_EQ(watched.recovery.status(), Status::kLost);
  EXPECT_FALSE(watched.recovery.mustMove());
}

/// Somebody walks along with the robot, who is on no map.
TEST(Recovery, WhileTrackingObstaclesAreNoEvidenceOfWhereTheRobotIs) {
  Watched watched(asymmetricWorld());
  const Pose2 truth{2.0, 3.0, -0.5};
  const Scan clear = watched.laser.observe(watched.map, truth).scan;
  Scan seen = clear;
  for (int i = 20; i < 40; ++i) {
    seen.range[i] *= 0.6F;
    seen.x[i] = seen.range[i] * std::cos(seen.bearing[i]);
    seen.y[i] = seen.range[i] * std::sin(seen.bearing[i]);
  }
  watched.tell(truth);
  EXPECT_EQ(watched.recovery.evidenceOf(truth, seen).hits(), seen.hits());  // told, not seen yet
  watched.see(truth, truth);
  ASSERT_EQ(watched.recovery.status(), Status::kTracking);
  EXPECT_EQ(watched.recovery.evidenceOf(truth, clear).hits(), clear.hits());
  const Scan left = watched.recovery.evidenceOf(truth, seen);
  ASSERT_EQ(left.hits(), seen.hits() - 20);
  EXPECT_EQ(left.range[19], clear.range[19]);
  EXPECT_EQ(left.bearing[20], clear.bearing[40]);
  EXPECT_EQ(left.x[20], clear.x[40]);
  const Pose2 wrong = truth * Pose2{0.0, 0.5, 0.3};  // hardly anything is on walls there
  EXPECT_EQ(watched.recovery.evidenceOf(wrong, seen).hits(), seen.hits());
}

/// Nobody knows at which end of the hall the robot is; a core that goes to and fro is no news.
TEST(Recovery, APoseStaysAtOneOfTwoEndsThatLookAlike) {
  Watched watched(symmetricWorld());
  const Pose2 truth{1.0, 0.7, 0.4};
  watched.recovery.reset(Anywhere{});
  Pose2 published = truth;
  for (int i = 0; i < 10; ++i) {
    const Pose2 core = i % 2 == 0 ? truth : twinOf(truth);
    watched.see(truth, core);
    ASSERT_EQ(watched.recovery.status(), Status::kAmbiguous) << i;
    const Estimate estimate{core, Eigen::Matrix3d::Identity() * 1e-3, {}};
    published = watched.recovery.published(published, estimate);
    EXPECT_THAT(published, PoseNear(truth, 0.1, 0.1)) << i;
  }
}

/// It was carried to where two places look alike, or its initial pose is wrong: which one it is
/// nobody knows, but not the old one.
class RobotThatIsNotWhereItWas : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(TrackedForMetres, RobotThatIsNotWhereItWas, testing::Values(0.0, 2.0));

TEST_P(RobotThatIsNotWhereItWas, IsInAPlaceThatIsLeftSomeWayAfterItLeftTheOld) {
  Watched watched(hollow(*toyWorld({"####################",  //
                                    "#.......#....##....#",  //
                                    "#.......#....##....#",  //
                                    "#.......#...###...##",  //
                                    "#..##...#....##....#",  //
                                    "#..##...############",  //
                                    "#.......############",  //
                                    "#.......############",  //
                                    "####################"},
                                   0.05, {}, 10)));
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.track(truth, GetParam());
  Pose2 by_odometry = watched.believed;
  truth = {5.3, 3.0, 0.3};
  for (int i = 0; i < 3 && !watched.recovery.mustMove(); ++i) watched.see(truth, watched.believed);
  ASSERT_TRUE(watched.recovery.mustMove());
  const auto published = [&] {
    return watched.recovery.published(by_odometry, {truth, 1e-3 * Eigen::Matrix3d::Identity(), {}});
  };
  watched.see(truth, truth);
  ASSERT_EQ(watched.recovery.status(), Status::kAmbiguous);
  EXPECT_THAT(published(), PoseNear(by_odometry, 1e-9, 1e-9));
  for (int i = 0; i < 32; ++i) {  // to and fro
    const Pose2 motion{i % 4 < 2 ? 0.1 : -0.1, 0.0, 0.0};
    truth = truth * motion;
    by_odometry = by_odometry * motion;
    watched.see(truth, truth, motion);
    ASSERT_EQ(watched.recovery.status(), Status::kAmbiguous) << i;
  }
  EXPECT_THAT(published(), PoseNear(truth, 1e-9, 1e-9));
}

/// As on a poor map: what is published must not be worse than what a core makes of it alone.
TEST(Recovery, WhileNoScanFitsThePoseIsWhereTheCoreHasIt) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.track(truth, 2.0);
  const Pose2 by_odometry = truth * Pose2{0.15, -0.2, 0.2};  // wheels slip
  Observations seen = watched.laser.observe(watched.map, truth);
  Scan& scan = seen.scan;
  for (Eigen::Index i = 0; i < scan.range.size(); ++i) {  // no place of this map looks so
    const float share = i % 3 == 0 ? 1.0F : 0.6F;
    for (Eigen::ArrayXf* lengths : {&scan.x, &scan.y, &scan.range}) (*lengths)[i] *= share;
  }
  for (int i = 0; i < 5; ++i) watched.observe(seen, truth);
  EXPECT_EQ(watched.recovery.status(), Status::kLost);
  const Estimate core{truth, Eigen::Matrix3d::Identity(), {}};
  EXPECT_EQ(watched.recovery.published(by_odometry, core).y, truth.y);
  const Estimate far{{7.5, 4.1, 2.0}, Eigen::Matrix3d::Identity(), {}};
  EXPECT_EQ(watched.recovery.published(by_odometry, far).y, by_odometry.y);
  EXPECT_EQ(watched.recovery.confidence(by_odometry, far.T_map_base), 0.0);
  EXPECT_EQ(watched.recovery.confidence(truth, truth), watched.recovery.fit().value());
}

/// A room, and a hall beside it in which a short-sighted laser sees where along it is only by the
/// block.
std::shared_ptr<const OccupancyGrid> hallWorld() {
  return hollow(*toyWorld({"################################",  //
                           "#.......#......................#",  //
                           "#..###..#......................#",  //
                           "#....#..#...##.................#",  //
                           "#.......#...##.................#",  //
                           "################################"},
                          0.05, {}, 10));
}

constexpr Pose2 kAtTheBlock{6.6, 2.2, 0.0}, kFarther{2.0, 0.0, 0.0};

struct WatchedInTheHall : Watched {
  WatchedInTheHall() : Watched(hallWorld()) { laser.max_range = 4.0; }

  /// How many places are left once the core jumps along the hall.
  std::size_t placesAfterAJumpFrom(const Pose2& truth) {
    see(truth, truth * kFarther);
    return recovery.modes().size();
  }
};

TEST(Recovery, OddsOfTrackingGrowWithTheWay) {
  for (const double metres : {0.5, 4.0}) {
    WatchedInTheHall watched;
    Pose2 truth = kAtTheBlock;
    watched.recovery.reset(Anywhere{});
    watched.believed = truth;
    watched.see(truth, truth);
    ASSERT_EQ(watched.recovery.status(), Status::kTracking);
    watched.track(truth, metres);
    const std::size_t left = watched.placesAfterAJumpFrom(truth);
    if (metres < 1.0) {
      EXPECT_GT(left, 1U);
    } else {
      EXPECT_EQ(left, 1U);
    }
    EXPECT_GT(watched.shareOf(truth), 0.5);
  }
}

/// It drove without seeing anything, and its wheels spun: the robot is where a core has it that
/// knew how little it knew of the way, unless the scan fits as well where odometry has it, and not
/// where a core jumps.
TEST(Recovery, APlaceIsWhereTheCoresCloudShrinksToButNotWhereTheCoreJumps) {
  struct Drive {
    double deviation, aside;  // m, along the hall by the core; by odometry, of each step
    bool can_be_there;
  };
  for (const auto& [deviation, aside, can_be_there] :
       {Drive{1.0, -0.01, true}, Drive{0.1, -0.01, false}, Drive{1.0, 0.0, false}}) {
    WatchedInTheHall watched;
    Pose2 truth{5.2, 2.2, 0.0}, by_odometry = truth;
    const Eigen::Matrix3d covariance =
        Eigen::Vector3d(deviation * deviation, 1e-3, 1e-3).asDiagonal();
    watched.tell(truth);
    watched.see(truth, truth);
    watched.laser.max_range = 0.1;
    for (int i = 0; i < 5; ++i) {
      const Pose2 motion{0.5, aside, 0.0};  // of the wheels
      by_odometry = by_odometry * motion;
      watched.observe(watched.laser.observe(watched.map, truth), by_odometry, motion, covariance);
    }
    watched.laser.max_range = 1.1;  // all that it sees is a wall beside it
    watched.see(truth, truth);
    const Estimate core{truth, 1e-3 * Eigen::Matrix3d::Identity(), {}};
    EXPECT_THAT(watched.recovery.published(by_odometry, core),
                PoseNear(can_be_there ? truth : by_odometry, 1e-9, 1e-9));
    watched.see(truth, truth);
    EXPECT_EQ(watched.recovery.status(), can_be_there ? Status::kTracking : Status::kLost);
    EXPECT_EQ(watched.shareOf(by_odometry), can_be_there ? 0.0 : 1.0);
  }
}

/// It was told to be farther along the hall, where most of the scan fits.
TEST(Recovery, ARobotThatStandsStillLearnsNothingNew) {
  WatchedInTheHall watched;
  Pose2 truth = kAtTheBlock;
  Pose2 told = truth * kFarther;
  watched.tell(told);
  watched.see(truth, told);
  const double share = watched.shareOf(told);
  EXPECT_GT(share, 0.5);
  for (int i = 0; i < 20; ++i) watched.see(truth, told);
  EXPECT_DOUBLE_EQ(watched.shareOf(told), share);
  EXPECT_FALSE(watched.recovery.mustMove());
  const Pose2 motion{-0.3, 0.0, 0.0};
  truth = truth * motion;
  told = told * motion;
  watched.see(truth, told, motion);
  EXPECT_LT(watched.shareOf(told), share);
}

/// It was carried to a place that looks as another one did for a while: a search that is under way
/// will tell.
TEST(Recovery, ALostRobotIsNotTrackedBeforeTheSearchHasItsAnswer) {
  Watched watched(asymmetricWorld());
  const Pose2 here{2.0, 3.0, -0.5}, there{8.0, 1.0, 2.0};
  const auto see = [&](const Pose2& truth, SearchWork work) {
    watched.places().beginUpdate({}, work);
    watched.see(truth, here);
  };
  watched.tell(here);
  see(here, kUnlimitedWork);
  ASSERT_EQ(watched.recovery.status(), Status::kTracking);
  for (int i = 0; i < 5; ++i) see(there, 1);
  ASSERT_EQ(watched.recovery.status(), Status::kLost);
  ASSERT_TRUE(watched.recovery.modes().empty()) << "there is no answer yet";
  for (int i = 0; i < 5; ++i) {
    see(here, 1);
    EXPECT_EQ(watched.recovery.status(), Status::kLost);
  }
  see(here, kUnlimitedWork);
  EXPECT_NE(watched.recovery.status(), Status::kLost);
  EXPECT_FALSE(watched.recovery.modes().empty());
}

/// The status after so many scans, a quarter of which does not fit, while a search is under way.
Status statusInDoubt(Watched& watched, Pose2 truth, int scans) {
  for (int i = 0; i < scans; ++i) {
    watched.places().beginUpdate({}, 1);
    watched.observe(withBystanders(watched.laser.observe(watched.map, truth), 4), truth);
  }
  return watched.recovery.status();
}

/// There may be another place until the search has its answer, unless tracking has earned more.
TEST(Recovery, APlaceThatScansToldIsOneOfSeveralWhileASearchForOthersTakesLong) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 2.2, 0.0};
  watched.recovery.reset(Anywhere{});
  watched.places().beginUpdate({}, kUnlimitedWork);
  watched.see(truth, truth);
  ASSERT_EQ(watched.recovery.status(), Status::kTracking);
  Watched tracked(asymmetricWorld());
  tracked.recovery.copyStateOf(watched.recovery);
  EXPECT_EQ(statusInDoubt(watched, truth, 3), Status::kTracking);
  EXPECT_EQ(statusInDoubt(watched, truth, 1), Status::kAmbiguous);
  watched.places().beginUpdate({}, kUnlimitedWork);
  watched.see(truth, truth);
  EXPECT_EQ(watched.recovery.status(), Status::kTracking) << "it has its answer";

  tracked.places().beginUpdate({}, kUnlimitedWork);
  tracked.believed = truth;
  tracked.track(truth, 3.0);
  EXPECT_EQ(statusInDoubt(tracked, truth, 6), Status::kTracking);
}

/// The scan that raised the doubt is weighed, though the answer comes with another one.
TEST(Recovery, ADoubtIsSettledByTheScanThatRaisedItToo) {
  Watched watched(asymmetricWorld());
  const Pose2 here{2.0, 3.0, -0.5};
  Pose2 there{8.0, 1.0, 2.0}, believed = here, odometry;
  watched.tell(here);
  watched.places().beginUpdate({}, kUnlimitedWork);
  watched.see(here, here);
  const Pose2 motion{0.05, 0.0, 0.1};
  for (const SearchWork work : {SearchWork{1}, SearchWork{1}, kUnlimitedWork}) {
    there = there * motion;
    believed = believed * motion;
    odometry = odometry * motion;
    watched.places().beginUpdate(odometry, work);
    watched.see(there, believed, motion);
  }
  ASSERT_TRUE(watched.places().askedBefore(watched.laser.observe(watched.map, there)));
  ASSERT_FALSE(watched.recovery.modes().empty());
  EXPECT_THAT(watched.recovery.modes().front().T_map_base, PoseNear(there, 0.05, 0.03));
  EXPECT_GT(watched.shareOf(there), 2.0 * watched.shareOf(believed));
}

/// Odometry drifts meanwhile: what was searched for in another race tells nothing in this one.
TEST(Recovery, ASearchThatTookTooLongIsForgottenWithTheRaceThatItWasFor) {
  Watched watched(asymmetricWorld());
  const Pose2 here{2.0, 3.0, -0.5}, there{8.0, 1.0, 2.0}, beside{8.05, 1.0, 2.0};
  const auto see = [&](const Pose2& truth, const Pose2& core, SearchWork work) {
    watched.places().beginUpdate({}, work);
    watched.see(truth, core);
  };
  watched.tell(here);
  see(here, here, kUnlimitedWork);
  for (int i = 0; i < 5; ++i) see(there, here, 1);
  ASSERT_TRUE(watched.recovery.modes().empty()) << "there is no answer yet";
  watched.tell(beside);
  see(beside, beside, kUnlimitedWork);
  EXPECT_FALSE(watched.places().askedBefore(watched.laser.observe(watched.map, beside)));
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
}

/// What was moved spoils some scans: with how much of the way behind it a place is compared with
/// others, m; nothing if it never is.
double wayUntilCompared(Watched& watched, Pose2 truth) {
  const Pose2 motion{0.1, 0.0, 0.0};
  for (double way = 0.1; way < 1.5; way += 0.1) {
    truth = truth * motion;
    const Observations seen = withBystanders(watched.laser.observe(watched.map, truth), 3, 0.8F);
    watched.observe(seen, truth, motion);
    if (watched.places().askedBefore(seen) || !watched.recovery.modes().empty()) return way;
  }
  return 0.0;
}

TEST(Recovery, APlaceThatWasToldIsComparedWithOthersAfterSomeWay) {
  const Pose2 here{1.0, 2.2, 0.0};
  Watched watched(asymmetricWorld());
  watched.tell(here);
  watched.see(here, here);
  ASSERT_EQ(watched.recovery.status(), Status::kTracking);
  const double way = wayUntilCompared(watched, here);
  EXPECT_GT(way, 0.45);
  EXPECT_LT(way, 0.85);
}

/// Odometry says forward while the robot stands, some of the scan does not fit, and each search has
/// its answer at once: the place is followed by scans from one doubt to the next.
TEST(Recovery, AKeptPlaceIsFollowedFromOneDoubtToTheNext) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 2.2, 0.0};
  watched.tell(truth);
  watched.track(truth, 5.0);
  const Pose2 motion{0.2, 0.0, 0.0};
  Pose2 core = truth;  // which refuses the scans
  for (int i = 0; i < 15 && !watched.recovery.mustMove(); ++i) {
    core = core * motion;
    watched.observe(withBystanders(watched.laser.observe(watched.map, truth), 3, 0.8F), core,
                    motion);
  }
  ASSERT_TRUE(watched.recovery.mustMove());
  EXPECT_THAT(watched.recovery.modes().front().T_map_base, PoseNear(truth, 0.1, 0.05));
}

/// What is usual, m, after a drive on a map that lacks much of what the laser sees, where two of
/// three updates may search for so much.
double usualAfterADrive(SearchWork work) {
  Watched watched(asymmetricWorld());
  const Pose2 motion{0.1, 0.0, 0.0};
  Pose2 truth{1.0, 2.2, 0.0}, odometry;
  watched.tell(truth);
  for (int i = 0; i < 60; ++i) {
    watched.places().beginUpdate(odometry, i % 3 == 0 ? kUnlimitedWork : work);
    Observations seen = watched.laser.observe(watched.map, truth);
    Scan& scan = seen.scan;
    for (Eigen::Index k = i % 3; k < scan.range.size(); k += 3) {
      const float nearer = std::max(0.2F, scan.range[k] - 0.6F) / scan.range[k];
      scan.range[k] *= nearer;
      scan.x[k] *= nearer;
      scan.y[k] *= nearer;
    }
    watched.observe(seen, truth, i == 0 ? Pose2{} : motion);
    truth = truth * motion;
    odometry = odometry * motion;
  }
  return watched.recovery.usual().value();
}

/// No place explains the scans better, and that is learned as soon where a search takes three
/// scans.
TEST(Recovery, ScansThatWaitForASearchTellWhatIsUsual) {
  const double at_once = usualAfterADrive(kUnlimitedWork);
  EXPECT_GT(at_once, 0.06);
  EXPECT_GT(usualAfterADrive(1), 0.97 * at_once);
}

TEST(Recovery, APlaceThatIsFoundDoesNotInheritTheOddsOfTheOneThatWasLeft) {
  WatchedInTheHall watched;
  Pose2 truth{0.8, 0.75, 0.0};
  watched.tell(truth);
  watched.track(truth, 2.0);
  truth = kAtTheBlock;
  for (int i = 0; i < 3 && !watched.recovery.mustMove(); ++i) watched.see(truth, watched.believed);
  ASSERT_TRUE(watched.recovery.mustMove());
  watched.see(truth, truth);
  ASSERT_EQ(watched.recovery.status(), Status::kTracking);
  watched.track(truth, 0.5);
  EXPECT_GT(watched.placesAfterAJumpFrom(truth), 1U);
}

/// Where it slipped from was known, and so it is known where it slipped to.
TEST(Recovery, APlaceThatWheelsSlippedToInheritsTheOddsOfTheOneThatWasLeft) {
  WatchedInTheHall watched;
  Pose2 truth{0.8, 0.75, 0.0};
  watched.tell(truth);
  watched.track(truth, 2.0);
  for (int i = 0; i < 40 && (i == 0 || watched.recovery.status() != Status::kTracking); ++i) {
    const Pose2 motion{i % 4 < 2 ? 0.1 : -0.1, 0.0, 0.1};
    truth = truth * motion;
    watched.see(truth, truth, i == 0 ? Pose2{0.1, 0.0, 0.7} : motion);
  }
  ASSERT_EQ(watched.recovery.status(), Status::kTracking);
  EXPECT_EQ(watched.placesAfterAJumpFrom(kAtTheBlock), 1U);
}

/// Of a tracked robot to which some scans of another kind were sent while it drove to and fro: how
/// many places are left once its core jumps along the hall.
std::size_t placesAfter(int scans, const std::function<Observations(const Observations&)>& changed,
                        double view = kPi, double step = 0.1) {
  WatchedInTheHall watched;
  Pose2 truth = kAtTheBlock;
  watched.tell(truth);
  watched.see(truth, truth);
  watched.track(truth, 4.0);
  const Observations seen = watched.laser.observe(watched.map, truth);
  for (int i = 0; i < scans; ++i) {
    Observations sent = changed(seen);
    sent.scan.view.width = view;
    const Pose2 motion{i % 2 == 0 ? -step : step, 0.0, 0.0};
    truth = truth * motion;
    watched.recovery.seesCarrying(truth, sent.scan);
    watched.observe(sent, truth, motion);
  }
  for (int i = 0; i < 3; ++i) watched.see(truth, truth);
  return watched.placesAfterAJumpFrom(truth);
}

Observations withRanges(Observations seen, float share) {
  for (Eigen::ArrayXf* lengths : {&seen.scan.x, &seen.scan.y, &seen.scan.range}) *lengths *= share;
  return seen;
}

TEST(Recovery, ACoverTakesOddsAwayUnlessSomebodyOnlyPassesBy) {
  const auto covered = [](const Observations&) { return coveredScan(); };
  EXPECT_EQ(placesAfter(14, covered), 1U);
  EXPECT_GT(placesAfter(60, covered), 1U);
}

TEST(Recovery, ScansThatContradictAPlaceTakeOddsAwayUnlessSomethingFillsACamerasView) {
  const auto hidden = [](const Observations& seen) { return withRanges(seen, 0.4F); };
  const auto beyond = [](const Observations& seen) { return withRanges(seen, 1.7F); };
  constexpr double kCamera = 1.0;  // rad
  EXPECT_EQ(placesAfter(60, hidden, kCamera), 1U);
  EXPECT_GT(placesAfter(60, beyond, kCamera), 1U);
  EXPECT_GT(placesAfter(60, hidden), 1U);
  EXPECT_EQ(placesAfter(60, hidden, kPi, 0.0), 1U)
      << "from one place they are hardly more than one";
}

/// Nobody is carried little by little: it is the map that is wrong about what a camera sees.
TEST(Recovery, ViewsThatContradictAPlaceTakeNoOddsAwayWhereEachGoesOnWithTheOneBefore) {
  constexpr double kCamera = 1.0;  // rad
  int scans = 0;
  const auto ever_longer = [&](const Observations& seen) {
    return withRanges(seen, std::min(1.7F, 1.0F + 0.02F * static_cast<float>(scans++)));
  };
  EXPECT_EQ(placesAfter(95, ever_longer, kCamera), 1U);
  const auto longer_at_once = [](const Observations& seen) { return withRanges(seen, 1.7F); };
  EXPECT_GT(placesAfter(60, longer_at_once, kCamera), 1U);
}

/// Two scans told lies: the core was moved to where they seemed to be from.
TEST(Recovery, APlaceThatWasLeftIsAmongThoseThatAreComparedNext) {
  WatchedInTheHall watched;
  Pose2 truth{0.8, 0.75, 0.0};
  watched.tell(truth);
  watched.track(truth, 1.5);
  Pose2 wrong = kAtTheBlock;
  for (int i = 0; i < 3 && !watched.recovery.mustMove(); ++i) watched.see(wrong, watched.believed);
  ASSERT_TRUE(watched.recovery.mustMove());
  watched.see(wrong, wrong);
  ASSERT_EQ(watched.recovery.status(), Status::kTracking);
  const Pose2 motion{0.1, 0.0, 0.0};
  truth = truth * motion;
  wrong = wrong * motion;
  Observations unlike = watched.laser.observe(watched.map, truth);
  for (Eigen::Index i = 0; i < unlike.scan.range.size(); ++i) {  // no place of this map looks so
    const float share = i % 2 == 0 ? 2.5F : 0.6F;
    for (auto* lengths : {&unlike.scan.x, &unlike.scan.y, &unlike.scan.range}) {
      (*lengths)[i] *= share;
    }
  }
  watched.observe(unlike, wrong, motion);
  EXPECT_GT(watched.shareOf(truth), 0.0);
  for (int i = 0; i < 8 && !watched.recovery.mustMove(); ++i) {
    truth = truth * motion;
    watched.see(truth, watched.believed * motion, motion);
  }
  ASSERT_TRUE(watched.recovery.mustMove());
  EXPECT_GT(watched.shareOf(truth), 0.4);  // and at most one looks alike
}

/// A hall of 80 m by 6 m with equal blocks in it.
std::shared_ptr<const OccupancyGrid> longHall(const std::vector<std::size_t>& columns = {30, 110}) {
  Art art(12, "#" + std::string(158, '.') + "#");
  art.front() = art.back() = std::string(160, '#');
  for (const std::size_t column : columns) {
    for (std::size_t row = 4; row < 9; ++row) art[row].replace(column, 3, "###");
  }
  return hollow(*toyWorld(art, 0.05, {}, 10));
}

/// Along its walls a short-sighted laser fits more places than can be followed.
TEST(Recovery, ThePlaceThatIsLeftOfThoseThatHadRoomIsComparedWithTheOthers) {
  Watched watched(longHall());
  watched.laser.max_range = 2.5;
  Pose2 truth{12.4, 1.0, 0.0}, twin{52.4, 1.0, 0.0};
  watched.recovery.reset(Anywhere{});
  watched.believed = twin;
  for (double way = 0.0; way < 3.0; way += 0.1) {  // past a block
    const Pose2 motion{way > 0.0 ? 0.1 : 0.0, 0.0, 0.0};
    truth = truth * motion;
    twin = twin * motion;
    watched.see(truth, twin, motion);
    EXPECT_NE(watched.recovery.status(), Status::kTracking) << way;
  }
  EXPECT_GT(watched.shareOf(truth), 0.0);
}

/// Past the only block of a hall, most of which looks the same.
TEST(Recovery, OneOfManyPlacesIsKnownOnceScansFitThereAsTheyUsuallyDo) {
  Watched watched(longHall({30}));
  watched.laser.max_range = 4.0;
  Pose2 truth{11.5, 1.0, 0.0};
  const Pose2 motion{0.1, 0.0, 0.0}, none{};
  const auto see = [&](int one_in, const Pose2& moved) {
    truth = truth * moved;
    const Observations seen = watched.laser.observe(watched.map, truth);
    watched.observe(one_in > 0 ? withBystanders(seen, one_in) : seen, truth, moved);
    return watched.recovery.status();
  };
  watched.recovery.reset(Anywhere{});
  watched.believed = truth;
  see(0, none);
  ASSERT_GE(watched.recovery.modes().size(), 10U);
  for (int i = 0; i < 60 && watched.recovery.status() != Status::kTracking; ++i) see(0, motion);
  ASSERT_EQ(watched.recovery.status(), Status::kTracking);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(see(8, motion), Status::kAmbiguous) << i;
  ASSERT_TRUE(watched.recovery.modes().empty()) << "no other is left";
  EXPECT_EQ(see(0, motion), Status::kTracking);
  EXPECT_EQ(see(8, motion), Status::kTracking);
}

/// symmetricWorld() but for one corner.
std::shared_ptr<const OccupancyGrid> almostSymmetricWorld() {
  return hollow(*toyWorld({"############",  //
                           "#..#.......#",  //
                           "#..#.......#",  //
                           "##......#..#",  //
                           "##......#..#",  //
                           "############"},
                          0.05, {}, 10));
}

/// Of a robot that turns until it sees that corner: radians from where no other place is left to
/// where it is tracked. One in so many beams hits a bystander.
double turnUntilTracked(int one_in) {
  constexpr double kStep = 0.1;
  Watched watched(almostSymmetricWorld());
  Pose2 truth{2.3, 1.0, 1.2};
  watched.recovery.reset(Anywhere{});
  watched.believed = truth;
  double alone = 0.0;
  for (double turned = 0.0; turned < 6.0; turned += kStep) {
    const Pose2 motion{0.0, 0.0, turned > 0.0 ? kStep : 0.0};
    truth = truth * motion;
    const Observations seen = watched.laser.observe(watched.map, truth);
    watched.observe(one_in > 0 ? withBystanders(seen, one_in) : seen, truth, motion);
    if (turned == 0.0) {
      EXPECT_EQ(watched.recovery.modes().size(), 2U);
    }
    if (watched.recovery.status() == Status::kTracking) return alone;
    alone += watched.recovery.modes().size() == 1 ? kStep : 0.0;
  }
  return kPi;
}

/// Where people stand, or the map is off, the true place may fit worse than another, and not be
/// found.
TEST(Recovery, OneOfSeveralThatFitsWorseThanIsUsualIsKnownOnlyAfterOtherViews) {
  EXPECT_EQ(turnUntilTracked(0), 0.0);
  const double turned = turnUntilTracked(6);
  EXPECT_GT(turned, 0.4);
  EXPECT_LT(turned, 2.0);
}

/// A hall of 24 m by 4 m with a block in it, whose walls are now 0.25, now 0.65 m thick.
std::shared_ptr<const OccupancyGrid> roughWorld() {
  constexpr int kColumns = 480, kRows = 100, kEnd = 10, kBay = 16;  // cells
  Art art(kRows, std::string(kColumns, '.'));
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const int depth = column / kBay % 2 == 0 ? 13 : 5;
      const bool is_side = row < depth || row >= kRows - depth;
      const bool is_end = column < kEnd || column >= kColumns - kEnd;
      const bool is_block = row > 30 && row < 50 && column > 300 && column < 330;
      if (is_side || is_end || is_block) {
        art[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = '#';
      }
    }
  }
  return toyWorld(art, 0.05);
}

/// Metres until the robot is tracked, from the first scan on; its core is always right.
double metresUntilTracked(Watched& watched, Pose2 truth, double most_confidence = 0.56) {
  const Pose2 motion{0.1, 0.0, 0.0};
  watched.believed = truth;
  watched.see(truth, truth);
  double metres = 0.0;
  for (; metres < 15.0 && watched.recovery.status() != Status::kTracking; metres += motion.x) {
    EXPECT_EQ(watched.recovery.status(), Status::kAmbiguous);
    EXPECT_LE(watched.recovery.confidence(truth, truth), most_confidence);
    truth = truth * motion;
    watched.see(truth, truth, motion);
  }
  return metres;
}

TEST(Recovery, OnARoughMapAPlaceThatNobodyToldIsKnownOnlyAfterSomeWay) {
  const Pose2 truth{3.0, 2.0, 0.0};
  Watched told(roughWorld());
  told.tell(truth);
  EXPECT_EQ(metresUntilTracked(told, truth), 0.0);
  Watched found(roughWorld());
  found.recovery.reset(Anywhere{});
  const double metres = metresUntilTracked(found, truth);
  EXPECT_GT(metres, 3.0);
  EXPECT_LT(metres, 15.0);
}

/// As drivers say that the lens is covered.
TEST(Recovery, ALaserNoneOfWhoseBeamsIsValidDoesNotTrack) {
  Watched watched(asymmetricWorld());
  Pose2 truth{1.0, 2.2, 0.0};
  watched.tell(truth);
  watched.track(truth, 1.0);
  Observations nothing;
  nothing.scan.invalid = 91;
  for (int i = 0; i < 3; ++i) watched.observe(nothing, truth);
  EXPECT_EQ(watched.recovery.status(), Status::kLost);
  for (int i = 0; i < 3; ++i) watched.see(truth, truth);
  EXPECT_EQ(watched.recovery.status(), Status::kTracking);
}

/// symmetricWorld() with a board of 0.6 m on a wall, by which its halves differ.
std::shared_ptr<const OccupancyGrid> worldWithBoard() {
  const auto world = symmetricWorld();
  std::vector<std::int8_t> values = world->cells();
  for (int i = 0; i < 12; ++i) {
    values[world->lattice().index({64, 10 + i})] = OccupancyGrid::kOccupied;
  }
  return std::make_shared<const OccupancyGrid>(world->lattice(), std::move(values));
}

/// Of two places that look nearly alike first one is likely, then the other, which may not be the
/// one, either.
TEST(Recovery, APlaceThatIsFoundAfterAnotherGaveWayIsKnownOnlyAfterSomeWay) {
  const auto metresAfter = [](int misleading_scans) {
    Watched watched(worldWithBoard());
    watched.recovery.reset(Anywhere{});
    Pose2 truth{2.0, 1.0, 0.0};
    watched.believed = truth;
    for (int i = 0; i < misleading_scans; ++i) watched.see(twinOf(truth), truth);
    for (int step = 0; step < 200; ++step) {  // to and fro
      const Pose2 motion{step % 40 < 20 ? 0.05 : -0.05, 0.0, 0.0};
      truth = truth * motion;
      watched.see(truth, truth, motion);
      if (watched.recovery.status() == Status::kTracking) return 0.05 * step;
    }
    return 10.0;
  };
  EXPECT_EQ(metresAfter(0), 0.0);
  EXPECT_GT(metresAfter(3), 1.9);  // after 0.7 m the other place is ruled out
  EXPECT_LT(metresAfter(3), 3.0);
}

TEST(Recovery, AScanWithoutHitsChangesNothing) {
  Watched watched(asymmetricWorld());
  watched.recovery.reset(Anywhere{});
  watched.observe(Observations{}, {2.0, 3.0, 0.0});
  EXPECT_EQ(watched.recovery.status(), Status::kGlobalizing);
  EXPECT_TRUE(watched.recovery.modes().empty());
}

TEST(Recovery, AnotherOneGoesOnWithWhatItKnows) {
  Watched one(symmetricWorld());
  Watched other(symmetricWorld());
  const Pose2 truth{2.3, 1.0, 0.0};
  one.recovery.reset(Anywhere{});
  one.believed = truth;
  one.see(truth, truth);
  other.recovery.copyStateOf(one.recovery);
  EXPECT_EQ(other.recovery.status(), Status::kAmbiguous);
  EXPECT_DOUBLE_EQ(other.shareOf(truth), one.shareOf(truth));
}

/// The twin of a place was ruled out by a wall that another map does not have.
TEST(Recovery, OnAnotherMapAPlaceIsComparedAnewUnlessTrackingHasEarnedIt) {
  const auto map = hollow(*toyWorld({"############",  //
                                     "#..#.......#",  //
                                     "#..#...#...#",  //
                                     "#.......#..#",  //
                                     "#.......#..#",  //
                                     "############"},
                                    0.05, {}, 10));
  for (const double metres : {0.2, 2.5}) {
    SCOPED_TRACE(metres);
    Watched one(map);
    Watched other(symmetricWorld());
    Pose2 truth{0.8, 1.0, 0.0};
    one.recovery.reset(Anywhere{});
    one.believed = truth;
    one.see(truth, truth);
    one.track(truth, metres);
    other.recovery.copyStateOf(one.recovery);
    other.believed = truth;
    other.see(truth, truth);
    const bool is_earned = metres > 2.0;
    EXPECT_EQ(other.recovery.status(), is_earned ? Status::kTracking : Status::kAmbiguous);
    EXPECT_EQ(other.shareOf(twinOf(truth)) > 0.0, !is_earned);
  }
}

/// The first map has one of two rooms, the second has both.
TEST(Recovery, PlacesOfAnotherMapJoinTheRace) {
  Watched one(hollow(*toyWorld({"############????????????",  //
                                "#..#.......#???????????#",  //
                                "#..#.......#???????????#",  //
                                "#.......#..#???????????#",  //
                                "#.......#..#???????????#",  //
                                "############????????????"},
                               0.05, {}, 10)));
  Watched other(hollow(*toyWorld({"########################",  //
                                  "#..#.......##..#.......#",  //
                                  "#..#.......##..#.......#",  //
                                  "#.......#..##.......#..#",  //
                                  "#.......#..##.......#..#",  //
                                  "########################"},
                                 0.05, {}, 10)));
  const Pose2 truth{0.8, 1.0, 0.0};
  one.recovery.reset(Anywhere{});
  one.believed = truth;
  one.see(truth, truth);
  ASSERT_EQ(one.recovery.modes().size(), 2U);
  other.recovery.copyStateOf(one.recovery);
  other.believed = truth;
  other.see(truth, truth);
  EXPECT_EQ(other.recovery.status(), Status::kAmbiguous);
  for (const Pose2& there : {truth, twinOf(truth)}) {
    const Pose2 in_the_other_room{there.x + 6.0, there.y, there.theta};
    EXPECT_NEAR(other.shareOf(in_the_other_room), 0.25, 0.01);
  }
}

/// Where it is after it was told and tracked for some metres; from then on no search gets on.
Pose2 trackedWithoutSearches(Watched& watched) {
  Pose2 truth{1.0, 1.0, 0.0};
  watched.tell(truth);
  watched.see(truth, truth);
  watched.track(truth, 3.0);
  watched.places().beginUpdate({}, 1);
  return truth;
}

/// Where scans do not fit and the core's place then moves by more than odometry can be off, the
/// robot may have been carried to a place that looks alike, unless a search finds none.
TEST(Recovery, APlaceThatSlidIsSuspectUntilNoneIsFoundThatLooksAlike) {
  const Pose2 pushed{0.3, 0.1, 0.0};
  for (const bool slides : {true, false}) {
    SCOPED_TRACE(slides ? "slides" : "stays");
    Watched watched(asymmetricWorld());
    Pose2 truth = trackedWithoutSearches(watched);
    for (int i = 0; i < 2; ++i) {
      watched.observe(withBystanders(watched.laser.observe(watched.map, truth), 3), truth);
      ASSERT_EQ(watched.recovery.status(), Status::kTracking);
    }
    if (slides) truth = truth * pushed;
    for (int i = 0; i < 3; ++i) {
      watched.see(truth, truth);
      ASSERT_EQ(watched.recovery.status(), slides ? Status::kAmbiguous : Status::kTracking);
      ASSERT_LE(watched.recovery.confidence(truth, truth), slides ? 0.56 : 1.0);
    }
    watched.places().beginUpdate({}, kUnlimitedWork);
    watched.see(truth, truth);
    EXPECT_EQ(watched.recovery.status(), Status::kTracking);
  }
}

/// A scan that fits far worse than the last one, beams of which go on through walls, may be the
/// first of a place that looks alike: others that fit again do not tell, until a search does.
TEST(Recovery, APlaceIsSuspectAfterAScanThatSuddenlyFitsFarWorse) {
  for (const bool is_sudden : {true, false}) {
    SCOPED_TRACE(is_sudden ? "sudden" : "bystanders");
    Watched watched(asymmetricWorld());
    Pose2 truth = trackedWithoutSearches(watched);
    const Observations seen = watched.laser.observe(watched.map, truth);
    is_sudden ? watched.see({8.0, 1.0, 2.0}, truth)
              : watched.observe(withBystanders(seen, 3), truth);
    for (int i = 0; i < 20; ++i) {
      const Pose2 motion{i < 10 ? 0.05 : -0.05, 0.0, 0.0};
      truth = truth * motion;
      watched.see(truth, truth, motion);
      ASSERT_EQ(watched.recovery.status(), is_sudden ? Status::kAmbiguous : Status::kTracking);
      ASSERT_EQ(watched.recovery.confidence(truth, truth) < 0.6, is_sudden);
    }
    watched.places().beginUpdate({}, kUnlimitedWork);
    watched.see(truth, truth);
    EXPECT_EQ(watched.recovery.status(), Status::kTracking) << "no other place looks like it";
  }
}

/// On a map on which half a turn looks alike: what tracking earned before on some metres rules out
/// that the robot was carried there, and on some centimetres it does not.
TEST(Recovery, ASuspicionEndsWhereTheOddsRuleOutThePlacesThatLookAlike) {
  for (const double metres : {2.4, 0.2}) {
    SCOPED_TRACE(metres);
    Watched before(asymmetricWorld()), watched(symmetricWorld());
    Pose2 truth{0.8, 1.0, 0.0};
    before.tell(truth);
    before.see(truth, truth);
    before.track(truth, metres);
    watched.recovery.copyStateOf(before.recovery);
    watched.believed = truth;
    watched.places().beginUpdate({}, 1);
    watched.see(truth, truth);
    ASSERT_EQ(watched.recovery.status(), Status::kTracking);
    const Observations seen = watched.laser.observe(watched.map, truth);
    watched.observe(withBystanders(seen, 2, 1.5F), truth);
    ASSERT_EQ(watched.recovery.status(), Status::kAmbiguous);
    watched.places().beginUpdate({}, kUnlimitedWork);
    for (int i = 0; i < 3; ++i) watched.see(truth, truth);
    EXPECT_EQ(watched.recovery.status(), metres > 1.0 ? Status::kTracking : Status::kAmbiguous);
  }
}

/// Places that were found before it was carried can only fit by chance.
TEST(Recovery, ALostRobotThatIsCarriedStartsAnew) {
  Watched watched(asymmetricWorld());
  const Pose2 here{2.0, 3.0, -0.5}, there{8.0, 1.0, 2.0}, elsewhere{5.0, 1.5, 0.3};
  watched.recovery.reset(Anywhere{});
  watched.places().beginUpdate({}, kUnlimitedWork);
  watched.observe(withBystanders(watched.laser.observe(watched.map, here), 2), elsewhere);
  ASSERT_FALSE(watched.recovery.modes().empty());
  watched.places().beginUpdate({}, 1);
  watched.recovery.seesCarrying({}, watched.laser.observe(watched.map, here).scan);
  ASSERT_TRUE(watched.recovery.seesCarrying({}, watched.laser.observe(watched.map, there).scan));
  watched.see(there, elsewhere);
  EXPECT_TRUE(watched.recovery.modes().empty()) << "what it found before is void";
  EXPECT_EQ(watched.recovery.status(), Status::kLost);
}

}  // namespace
}  // namespace adaptive_localization
