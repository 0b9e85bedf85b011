// SPDX-License-Identifier: BSD-3-Clause
#include "core/sweep_watch.hpp"

#include <gtest/gtest.h>

namespace adaptive_localization {
namespace {

constexpr double kPeriod = 0.1;  // s, between scans

LaserScan scanOf(double stamp, double sweep) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.ranges.assign(101, 1.0F);
  scan.time_increment = sweep / 100.0;
  return scan;
}

/// How many of so many scans are possible.
int countPossible(double sweep, int count = 20, double jitter = 0.0) {
  SweepWatch watch;
  int possible = 0;
  for (int i = 0; i < count; ++i) {
    const double stamp = 50.0 + kPeriod * i + (i % 2 == 0 ? 0.0 : jitter);
    possible += watch.isPossible("laser", scanOf(stamp, sweep)) ? 1 : 0;
  }
  return possible;
}

TEST(SweepWatch, SweepsUpToTheTimeBetweenScansAreBelieved) {
  EXPECT_EQ(countPossible(0.0), 20);
  EXPECT_EQ(countPossible(0.0133), 20) << "a SICK LMS";
  EXPECT_EQ(countPossible(kPeriod), 20) << "a laser that goes round and round";
}

TEST(SweepWatch, LongerOnesAreNotButForTheFirst) {
  EXPECT_EQ(countPossible(0.5), 1);
  EXPECT_EQ(countPossible(1.0), 1);
}

TEST(SweepWatch, StampsNeedNotBeExact) {
  EXPECT_EQ(countPossible(kPeriod, 20, 0.08), 20) << "in pairs";
}

TEST(SweepWatch, LasersAreToldApartByFrame) {
  SweepWatch watch;
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(watch.isPossible("slow", scanOf(1.0 * i, 0.9)));
    EXPECT_TRUE(watch.isPossible("fast", scanOf(1.0 * i + 0.01, 0.05)));
  }
}

TEST(SweepWatch, OnePauseDoesNotMakeLongSweepsPossible) {
  SweepWatch watch;
  for (int i = 0; i < 10; ++i) watch.isPossible("laser", scanOf(50.0 + kPeriod * i, 0.9));
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(watch.isPossible("laser", scanOf(60.0 + kPeriod * i, 0.9))) << i;
  }
}

TEST(SweepWatch, GoesOnWhenTimeJumpsBack) {
  SweepWatch watch;
  watch.isPossible("laser", scanOf(100.0, 0.0));
  watch.isPossible("laser", scanOf(100.1, 0.0));
  EXPECT_TRUE(watch.isPossible("laser", scanOf(7.0, 0.9))) << "again the first";
  EXPECT_FALSE(watch.isPossible("laser", scanOf(7.1, 0.9)));
}

}  // namespace
}  // namespace adaptive_localization
