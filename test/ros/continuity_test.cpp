// SPDX-License-Identifier: BSD-3-Clause
#include "ros/continuity.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

ros::Time at(double seconds) {
  return ros::Time(1000.0 + seconds);
}

TEST(StampWatch, TellsHowFarTimeJumped) {
  StampWatch watch;
  EXPECT_FALSE(watch.jumpTo("laser", at(0.0)));
  EXPECT_FALSE(watch.jumpTo("laser", at(0.1)));
  EXPECT_FALSE(watch.jumpTo("laser", at(9.0)));
  EXPECT_FALSE(watch.jumpTo("laser", at(8.5))) << "scans that come out of order";
  EXPECT_NEAR(watch.jumpTo("laser", at(19.0)).value(), 10.5, 1e-6);
  EXPECT_NEAR(watch.jumpTo("laser", at(17.0)).value(), -2.0, 1e-6);
}

TEST(StampWatch, LasersHaveClocksOfTheirOwn) {
  StampWatch watch;
  EXPECT_FALSE(watch.jumpTo("front", at(0.0)));
  EXPECT_FALSE(watch.jumpTo("rear", at(500.0)));
  EXPECT_FALSE(watch.jumpTo("front", at(0.1)));
  EXPECT_TRUE(watch.jumpTo("front", at(300.0)));
  EXPECT_FALSE(watch.jumpTo("rear", at(800.0))) << "the same jump";
}

TEST(Restart, IsAPauseAfterWhichOdometryStandsAtItsOrigin) {
  const Restart pause{at(0.0), at(3.0)}, step{at(0.0), at(0.5)};
  EXPECT_TRUE(isRestart(pause, {3.0, 1.0, 0.5}, {0.01, 0.0, 0.0}));
  EXPECT_FALSE(isRestart(step, {3.0, 1.0, 0.5}, {})) << "no pause";
  EXPECT_FALSE(isRestart(pause, {3.0, 1.0, 0.5}, {2.0, 1.0, 0.5})) << "elsewhere";
  EXPECT_FALSE(isRestart(pause, {0.1, 0.0, 0.0}, {})) << "it was there before";
  EXPECT_FALSE(isRestart({ros::Time(), at(3.0)}, {3.0, 1.0, 0.5}, {})) << "the first";
}

TEST(Restart, ContainsWhatTfMakesUp) {
  const Restart pause{at(0.0), at(3.0)};
  EXPECT_FALSE(pause.contains(at(0.0)));
  EXPECT_TRUE(pause.contains(at(1.5)));
  EXPECT_FALSE(pause.contains(at(3.0)));
}

TEST(OdometryWatch, SeesJumpsThatNoRobotCanDrive) {
  OdometryWatch watch;
  EXPECT_TRUE(watch.goesOn(at(0.0), {5.0, 0.0, 0.0}, {})) << "the first";
  EXPECT_TRUE(watch.goesOn(at(0.1), {6.0, 0.0, 0.0}, {}));
  EXPECT_FALSE(watch.goesOn(at(0.2), {9.0, 0.0, 0.0}, {}));
  EXPECT_TRUE(watch.goesOn(at(0.3), {9.1, 0.0, 0.0}, {}));
  watch.forget();
  EXPECT_TRUE(watch.goesOn(at(0.4), {90.0, 0.0, 0.0}, {}));
}

/// However long no scan came.
TEST(OdometryWatch, DrivingPastTheOriginIsNoRestart) {
  OdometryWatch watch;
  watch.goesOn(at(0.0), {1.0, 0.0, 0.0}, {});
  EXPECT_TRUE(watch.goesOn(at(2.0), {0.0, 0.0, 0.0}, {}));
}

TEST(OdometryWatch, SeesARestartOnce) {
  OdometryWatch watch;
  const Restart restart{at(1.0), at(4.0)};
  watch.goesOn(at(0.9), {1.0, 0.0, 0.0}, {});
  EXPECT_FALSE(watch.goesOn(at(4.1), {0.0, 0.0, 0.0}, restart));
  EXPECT_TRUE(watch.goesOn(at(4.2), {0.1, 0.0, 0.0}, restart));
}

/// Some scans come when tf knows more already.
TEST(OdometryWatch, ARestartThatIsStillToComeIsNone) {
  OdometryWatch watch;
  const Restart restart{at(1.0), at(4.0)};
  watch.goesOn(at(0.8), {1.0, 0.0, 0.0}, restart);
  EXPECT_TRUE(watch.goesOn(at(0.9), {1.0, 0.0, 0.0}, restart));
  EXPECT_FALSE(watch.goesOn(at(4.0), {0.0, 0.0, 0.0}, restart));
}

}  // namespace
}  // namespace adaptive_localization
