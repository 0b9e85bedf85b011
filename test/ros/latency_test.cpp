// SPDX-License-Identifier: BSD-3-Clause
#include "ros/latency.hpp"

#include <gtest/gtest.h>

#include "ros/processor_share.hpp"

namespace adaptive_localization {
namespace {

/// Scans every 0.1 s, of which number i, from 1 on, takes i ms from its arrival and, as its stamp
/// is 20 ms older, 20 ms more from that. Returns when the last was sent.
double addScans(Latency& latency, int count, double start = 1000.0) {
  double sent = start;
  for (int i = 1; i <= count; ++i) {
    const double delay = 1e-3 * i;
    sent = start + 0.1 * i + delay;
    latency.add(sent, delay + 0.02, delay);
  }
  return sent;
}

TEST(Latency, IsZeroWithoutScans) {
  const auto minute = Latency().lastMinute(1000.0);
  EXPECT_EQ(minute.scans, 0);
  EXPECT_EQ(minute.period, 0.0);
  EXPECT_EQ(minute.from_arrival.max, 0.0);
  EXPECT_FALSE(minute.isLate());
  EXPECT_FALSE(minute.isOtherClock());
}

TEST(Latency, QuantilesAreValuesThatCame) {
  Latency latency;
  const auto minute = latency.lastMinute(addScans(latency, 200));
  EXPECT_EQ(minute.scans, 200);
  EXPECT_NEAR(minute.from_arrival.median, 0.100, 1e-9);
  EXPECT_NEAR(minute.from_arrival.p99, 0.198, 1e-9);
  EXPECT_NEAR(minute.from_arrival.max, 0.200, 1e-9);
  EXPECT_NEAR(minute.from_stamp.median, 0.120, 1e-9);
  EXPECT_NEAR(minute.from_stamp.p99, 0.218, 1e-9);
  EXPECT_NEAR(minute.from_stamp.max, 0.220, 1e-9);
  EXPECT_NEAR(minute.period, 0.1, 1e-9);
}

TEST(Latency, OneScanHasNoPeriodAndIsNotLate) {
  Latency latency;
  latency.add(1000.0, 3.0, 2.0);
  const auto minute = latency.lastMinute(1000.0);
  EXPECT_EQ(minute.from_arrival.median, 2.0);
  EXPECT_EQ(minute.from_arrival.p99, 2.0);
  EXPECT_EQ(minute.period, 0.0);
  EXPECT_FALSE(minute.isLate());
}

TEST(Latency, WhatIsOlderThanAMinuteIsForgottenThoughNothingNewComes) {
  Latency latency;
  const double last = addScans(latency, 50);
  EXPECT_EQ(latency.lastMinute(last).scans, 50);
  EXPECT_EQ(latency.lastMinute(last + 59.9).scans, 1);
  EXPECT_EQ(latency.lastMinute(last + 60.1).scans, 0);
  latency.add(last + 100.0, 0.5, 0.5);
  const auto minute = latency.lastMinute(last + 100.0);
  EXPECT_EQ(minute.scans, 1);
  EXPECT_EQ(minute.from_arrival.max, 0.5);
}

TEST(Latency, OfMoreScansThanThereIsRoomForTheNewestAreKept) {
  Latency latency;
  for (int i = 0; i < 20000; ++i) latency.add(1000.0 + 0.001 * i, i, i);
  const auto minute = latency.lastMinute(1020.0);
  EXPECT_GE(minute.scans, 6000);
  EXPECT_LT(minute.scans, 20000);
  EXPECT_EQ(minute.from_arrival.max, 19999.0);
  EXPECT_EQ(minute.from_arrival.median, 20000.0 - minute.scans / 2 - 1);
}

TEST(Latency, IsLateWhenOneOfAHundredTakesLongerThanScansAreApart) {
  Latency latency;
  double now = 1000.0;
  for (int i = 0; i < 200; ++i) latency.add(now += 0.1, 0.03, i % 100 == 0 ? 0.09 : 0.02);
  EXPECT_FALSE(latency.lastMinute(now).isLate());
  latency.add(now += 0.1, 0.2, 0.2);  // a single one of 201 is the maximum, not the p99
  EXPECT_FALSE(latency.lastMinute(now).isLate());
  for (int i = 0; i < 3; ++i) latency.add(now += 0.1, 0.2, 0.2);
  EXPECT_TRUE(latency.lastMinute(now).isLate());
}

TEST(Latency, StampsOfAnotherClockAreCountedAndTheirFiguresToldAsTheyAre) {
  Latency latency;
  double now = 1000.0;
  for (int i = 0; i < 10; ++i) latency.add(now += 0.1, 0.05, 0.02);
  for (int i = 0; i < 6; ++i) latency.add(now += 0.1, -3600.0, 0.02);
  for (int i = 0; i < 4; ++i) latency.add(now += 0.1, 1.7e9, 0.02);
  auto minute = latency.lastMinute(now);
  EXPECT_EQ(minute.from_future, 6);
  EXPECT_EQ(minute.from_past, 4);
  EXPECT_EQ(minute.from_stamp.max, 1.7e9);
  EXPECT_EQ(minute.from_stamp.median, 0.05);
  EXPECT_EQ(minute.from_arrival.max, 0.02);
  EXPECT_FALSE(minute.isOtherClock()) << "half of them, not most";
  latency.add(now += 0.1, -3600.0, 0.02);
  EXPECT_TRUE(latency.lastMinute(now).isOtherClock());
}

TEST(Latency, AClockThatComesALittleLateIsNoOtherClock) {
  Latency latency;
  for (int i = 0; i < 10; ++i) latency.add(1000.0 + 0.1 * i, -0.01, 0.02);
  const auto minute = latency.lastMinute(1001.0);
  EXPECT_EQ(minute.from_future, 0);
  EXPECT_EQ(minute.from_stamp.median, -0.01);
}

TEST(ProcessorShare, IsProcessorTimeOverRealTimeOfTheLastMinute) {
  ProcessorShare share;
  EXPECT_EQ(share.at(1000.0), 0.0);
  share.add(1000.0, 5.0);
  EXPECT_EQ(share.at(1000.0), 0.0);
  share.add(1001.0, 5.25);
  EXPECT_NEAR(share.at(1001.0), 0.25, 1e-9);
  for (int i = 1; i <= 120; ++i) share.add(1001.0 + i, 5.25 + 1.5 * i);  // one and a half cores
  EXPECT_NEAR(share.at(1121.0), 1.5, 1e-9);
}

}  // namespace
}  // namespace adaptive_localization
