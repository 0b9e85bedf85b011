// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/scan_watch.hpp"

#include <gtest/gtest.h>

#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kHere{2.0, 3.0, -0.5};
const Pose2 kThere{6.5, 2.5, 3.0};

Scan seenFrom(const Pose2& pose, double view = kPi) {
  return ToyLaser{181, -0.5 * view, 0.5 * view, 12.0}.observe(asymmetricWorld(), pose).scan;
}

/// Something stands before so many of its beams, from the first on.
Scan withThingBefore(Scan scan, Eigen::Index beams) {
  scan.range.head(beams) *= 0.4F;
  return scan;
}

Scan covered() {
  Scan scan = seenFrom(kHere);
  scan.range *= 0.01F;
  return scan;
}

TEST(ScanWatch, TellsOnceThatTheRobotWasCarried) {
  ScanWatch watch;
  watch.observe({}, seenFrom(kHere));
  EXPECT_FALSE(watch.sawCarrying());
  watch.observe({}, seenFrom(kThere));
  watch.observe({}, seenFrom(kThere));
  EXPECT_TRUE(watch.sawCarrying()) << "until it was told";
  EXPECT_TRUE(watch.tellCarrying());
  EXPECT_FALSE(watch.sawCarrying());
  EXPECT_FALSE(watch.tellCarrying());
}

TEST(ScanWatch, SeesWhetherTheRobotStands) {
  ScanWatch watch;
  watch.observe({}, seenFrom(kHere));
  EXPECT_FALSE(watch.isAtRest()) << "nobody knows";
  watch.observe({0.001, 0.0, 0.001}, seenFrom(kHere));
  EXPECT_TRUE(watch.isAtRest());
  watch.observe({0.051, 0.0, 0.001}, seenFrom(kHere));
  EXPECT_FALSE(watch.isAtRest());
  watch.observe({0.051, 0.0, 0.051}, seenFrom(kHere));
  EXPECT_FALSE(watch.isAtRest());
}

TEST(ScanWatch, RemembersThatMuchCameNear) {
  ScanWatch watch;
  watch.observe({}, seenFrom(kHere));
  watch.observe({}, withThingBefore(seenFrom(kHere), 40));
  EXPECT_FALSE(watch.hasComeNear()) << "a fifth";
  watch.observe({}, withThingBefore(seenFrom(kHere), 120));
  EXPECT_TRUE(watch.hasComeNear());
  watch.observe({}, withThingBefore(seenFrom(kHere), 120));
  EXPECT_TRUE(watch.hasComeNear()) << "until it is forgotten";
  watch.forgetNear();
  EXPECT_FALSE(watch.hasComeNear());
}

/// One thing may fill it.
TEST(ScanWatch, NothingComesNearANarrowView) {
  ScanWatch watch;
  watch.observe({}, seenFrom(kHere, 1.2));
  watch.observe({}, withThingBefore(seenFrom(kHere, 1.2), 120));
  EXPECT_FALSE(watch.hasComeNear());
}

TEST(ScanWatch, TheFirstScanOfACoveredLaserIsToldFromLaterOnes) {
  ScanWatch watch;
  watch.observe({}, seenFrom(kHere));
  EXPECT_FALSE(watch.isJustCovered());
  watch.observe({}, covered());
  EXPECT_TRUE(watch.isJustCovered());
  watch.observe({}, covered());
  EXPECT_FALSE(watch.isJustCovered());
  watch.observe({}, seenFrom(kHere));
  EXPECT_FALSE(watch.isJustCovered());
}

TEST(ScanWatch, GoesOnAfterHalfAMetreOfScansThatFitAndDoNotChange) {
  ScanWatch watch;
  const auto drive = [&](double to) {
    watch.observe({to, 0.0, 0.0}, seenFrom(kHere * Pose2{to, 0.0, 0.0}));
    watch.fit({0.1, 0.0, 0.0});
  };
  for (const double to : {0.0, 0.1, 0.2, 0.3}) drive(to);
  EXPECT_FALSE(watch.goesOn());
  drive(0.4);
  drive(0.5);
  EXPECT_TRUE(watch.goesOn());
  watch.observe({0.5, 0.0, 0.0}, withThingBefore(seenFrom(kHere * Pose2{0.5, 0.0, 0.0}), 54));
  EXPECT_TRUE(watch.goesOn()) << "what three beams of ten see may be a thing, or behind a corner";
  ScanWatch broken = watch;
  broken.breakOff();
  EXPECT_FALSE(broken.goesOn()) << "whatever the scans show";
  watch.observe({0.5, 0.0, 0.0}, seenFrom(kThere));
  EXPECT_FALSE(watch.goesOn()) << "another place";
  watch.fit({0.6, 0.0, 0.0});
  EXPECT_FALSE(watch.goesOn()) << "the way there was not seen";
}

TEST(ScanWatch, DoesNotGoOnWhereNoScanWasLookedAt) {
  ScanWatch watch;
  for (int i = 0; i < 9; ++i) watch.fit({0.1, 0.0, 0.0});
  EXPECT_FALSE(watch.goesOn());
}

}  // namespace
}  // namespace adaptive_localization
