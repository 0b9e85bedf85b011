// SPDX-License-Identifier: BSD-3-Clause
// What a scan keeps of all that the laser saw, however much it is thinned.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();
const float kInf = std::numeric_limits<float>::infinity();

LaserScan message(std::vector<float> ranges, double angle_min = 0.0, double increment = 0.1) {
  LaserScan scan;
  scan.angle_min = angle_min;
  scan.angle_increment = increment;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  scan.ranges = std::move(ranges);
  return scan;
}

ScanOptions beams(int count) {
  ScanOptions options;
  options.laser_max_beams = count;
  return options;
}

/// Where a scan sees from and how far, in degrees.
struct View {
  double start, width;
};
View viewOf(int beams, double first, double step, const LaserMount& mount = {}) {
  constexpr double kDegree = kPi / 180.0;
  const std::vector<float> ranges(static_cast<std::size_t>(beams), 1.0F);
  const Scan scan = toScan(message(ranges, first * kDegree, step * kDegree), mount, ScanOptions{});
  return {scan.view.start / kDegree, scan.view.width / kDegree};
}

void expectView(const View& view, double start, double width) {
  const double off = std::remainder(view.start - start, 360.0);
  EXPECT_NEAR(off, 0.0, 1e-6) << "starts at " << view.start << ", expected " << start;
  EXPECT_NEAR(view.width, width, 1e-6);
}

TEST(ScanView, GoesFromTheRightmostBeamToTheLeftmost) {
  expectView(viewOf(181, -90, 1), -90, 180);
  expectView(viewOf(181, 90, -1), -90, 180);
  expectView(viewOf(180, -89.5, 1), -89.5, 179);
  expectView(viewOf(1, 30, 0), 30, 0);
  expectView(viewOf(2, 30, 1), 30, 1);
  expectView(viewOf(360, -180, 1), -180, 359);
  expectView(viewOf(361, 0, 1), 0, 360);
  expectView(viewOf(800, 0, 1), 0, 360);  // more than once round
}

TEST(ScanView, TurnsWithTheMount) {
  const LaserMount turned = LaserMount::level({0.1, 0.2, kPi / 6});
  expectView(viewOf(181, -90, 1, turned), -60, 180);
  expectView(viewOf(181, 90, -1, turned), -60, 180);
  expectView(viewOf(271, -135, 1, LaserMount::level({0, 0, kPi})), 45, 270);
  const LaserMount upside_down = LaserMount::upsideDown({0.1, 0.2, kPi / 6});
  expectView(viewOf(101, -30, 1, upside_down), -40, 100);  // -30 to 70, mirrored: -70 to 30
  expectView(viewOf(101, 70, -1, upside_down), -40, 100);
  expectView(viewOf(1, 20, 0, upside_down), 10, 0);
}

TEST(ScanView, IsTheSameWhateverTheBeamsRead) {
  const Scan all = toScan(message({1.0F, 1.0F, 1.0F}), LaserMount{}, beams(10));
  const Scan none = toScan(message({kNan, kInf, 0.0F}), LaserMount{}, beams(10));
  const Scan thinned = toScan(message({1.0F, 1.0F, 1.0F}), LaserMount{}, beams(2));
  for (const Scan& scan : {none, thinned}) {
    EXPECT_EQ(scan.view.start, all.view.start);
    EXPECT_EQ(scan.view.width, all.view.width);
  }
  EXPECT_NEAR(all.view.width, 0.2, 1e-12);
}

/// Beam i reads i + 1 m.
Scan thinnedScan(int count, double first, double step) {
  constexpr double kDegree = kPi / 180.0;
  LaserScan scan =
      message(std::vector<float>(static_cast<std::size_t>(count)), first * kDegree, step * kDegree);
  scan.range_max = 1000.0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    scan.ranges[i] = static_cast<float>(i + 1);
  }
  return toScan(scan, LaserMount{}, beams(2));
}

TEST(ScanView, HasABeamEveryTwoDegreesWhateverIsThinned) {
  for (const auto& [count, step] : {std::pair{361, 0.5}, {181, 1.0}, {91, 2.0}, {271, 2.0 / 3.0}}) {
    const Scan scan = thinnedScan(count, -90, step);
    ASSERT_EQ(scan.hits(), 2);
    ASSERT_EQ(scan.view.range.size(), 91);
    EXPECT_EQ(scan.view.spacing, ScanView::kFinest);
    for (int k = 0; k < 91; ++k) {
      EXPECT_EQ(std::lround(scan.view.range[k]), std::lround(k * 2.0 / step) + 1);
      EXPECT_NEAR(scan.view.bearing[k], (2.0 * k - 90.0) * kPi / 180.0, 1e-6);
    }
  }
}

TEST(ScanView, HasAllBeamsOfACoarseLaser) {
  for (const double sense : {1.0, -1.0}) {
    const Scan scan = thinnedScan(7, -90 * sense, 30 * sense);
    ASSERT_EQ(scan.view.range.size(), 7);
    EXPECT_NEAR(scan.view.spacing, kPi / 6, 1e-12);
    for (int k = 0; k < 7; ++k) {  // from the rightmost
      EXPECT_EQ(std::lround(scan.view.range[k]), sense > 0 ? k + 1 : 7 - k);
      EXPECT_NEAR(scan.view.bearing[k], (30.0 * k - 90.0) * kPi / 180.0, 1e-6);
    }
  }
}

TEST(ScanView, OfBeamsThatAllPointTheSameWayIsTheFirst) {
  for (const double increment : {1e-310, 1e-12, -1e-12}) {
    const Scan scan = toScan(message({1.0F, 1.0F, 1.0F}, 0.0, increment), LaserMount{}, beams(2));
    ASSERT_EQ(scan.view.range.size(), 1);
    EXPECT_EQ(scan.view.range[0], 1.0F);
  }
}

TEST(ScanView, TellsKindsOfBeamApart) {
  const Scan scan = toScan(message({kNan, 1.0F, kInf, 0.05F, 99.0F}), LaserMount{}, beams(2));
  ASSERT_EQ(scan.view.range.size(), 5);
  EXPECT_TRUE(std::isnan(scan.view.range[0]));
  EXPECT_EQ(scan.view.range[1], 1.0F);
  EXPECT_EQ(scan.view.range[2], kInf);
  EXPECT_TRUE(std::isnan(scan.view.range[3]));
  EXPECT_EQ(scan.view.range[4], kInf);
}

}  // namespace
}  // namespace adaptive_localization
