// SPDX-License-Identifier: BSD-3-Clause
// Scans, mounts and stamps out of a CARMEN log.
#include <gmock/gmock.h>

#include "eval/small_carmen_log.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(CarmenLog, ReadsFlaser) {
  const Log log = read(kSmallLog);
  EXPECT_THAT(log.warnings, IsEmpty());
  EXPECT_EQ(log.skipped, 0);
  ASSERT_EQ(log.scans.size(), 2U);
  const LogScan& scan = log.scans[1];
  EXPECT_DOUBLE_EQ(scan.scan.stamp, 10.2);
  EXPECT_THAT(scan.scan.ranges, ElementsAre(1.5F, 2.5F, 3.5F));
  EXPECT_DOUBLE_EQ(scan.scan.range_max, 50.0);
  EXPECT_DOUBLE_EQ(scan.T_odom_base.x, 1.0);
  EXPECT_DOUBLE_EQ(scan.T_odom_base.y, 2.0);
  EXPECT_DOUBLE_EQ(scan.T_odom_base.theta, 0.5);
  EXPECT_DOUBLE_EQ(scan.mount.position.x(), 0.25);
  EXPECT_FALSE(scan.T_map_base);
}

struct Fan {
  int beams;
  double increment_deg, last_deg;
};

class CarmenFan : public testing::TestWithParam<Fan> {};

TEST_P(CarmenFan, SpansHalfACircle) {
  std::string line = "FLASER " + std::to_string(GetParam().beams);
  for (int i = 0; i < GetParam().beams; ++i) line += " 1.0";
  const Log log = read(line + " 0 0 0 0 0 0 1.0 host 1.0\n");
  ASSERT_EQ(log.scans.size(), 1U);
  const LaserScan& scan = log.scans[0].scan;
  const double last = scan.angle_min + (GetParam().beams - 1) * scan.angle_increment;
  EXPECT_NEAR(scan.angle_min, -kPi / 2, 1e-12);
  EXPECT_NEAR(scan.angle_increment * 180 / kPi, GetParam().increment_deg, 1e-12);
  EXPECT_NEAR(last * 180 / kPi, GetParam().last_deg, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Lasers, CarmenFan,
                         testing::Values(Fan{180, 1.0, 89.0}, Fan{181, 1.0, 90.0},
                                         Fan{360, 0.5, 89.5}, Fan{361, 0.5, 90.0}));

TEST(CarmenLog, ReadsRobotLaser) {
  const Log log = read(
      "PARAM robot_frontlaser_offset 0.1 host 0\n"
      "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 2 7 8 0.1 0 0 4 5 6 0 0 0.3 0.3 1e10 "
      "99.5 host 9.5\n");
  EXPECT_THAT(log.warnings, IsEmpty());
  ASSERT_EQ(log.scans.size(), 1U);
  const LogScan& scan = log.scans[0];
  EXPECT_DOUBLE_EQ(scan.scan.angle_min, -1.5);
  EXPECT_DOUBLE_EQ(scan.scan.angle_increment, 1.5);
  EXPECT_DOUBLE_EQ(scan.scan.range_max, 20.0);
  EXPECT_DOUBLE_EQ(scan.scan.stamp, 99.5);
  EXPECT_DOUBLE_EQ(scan.T_odom_base.x, 4.0);
  EXPECT_NEAR(scan.T_odom_base.theta, 6.0 - 2.0 * kPi, 1e-12);
}

TEST(CarmenLog, TakesOneKindOfScanOnly) {
  const Log log = read(
      "FLASER 2 1 2 0 0 0 0 0 0 1.0 host 1.0\n"
      "ROBOTLASER1 0 -1.5 3.0 3.0 20.0 0.01 0 2 1 2 0 0 0 0 0 0 0 0 0 0.3 0.3 1e10 1.0 host 1\n");
  EXPECT_EQ(log.scans.size(), 1U);
}

TEST(CarmenLog, SaysThatTheMountIsAGuess) {
  const Log log = read("FLASER 2 1 2 0 0 0 0 0 0 1.0 host 1.0\n");
  EXPECT_THAT(log.warnings, Contains(HasSubstr("robot_frontlaser_offset")));
}

TEST(CarmenLog, SpreadsLateStampsBetweenTheirNeighbours) {
  std::string text = "PARAM robot_frontlaser_offset 0 host 0\n";
  for (const char* stamp : {"5.0", "1.0", "6.0", "7.0", "4.0", "4.0", "8.0"}) {
    text += std::string("FLASER 2 1 2 0 0 0 0 0 0 ") + stamp + " host 1\n";
  }
  const Log log = read(text);
  std::vector<double> stamps;
  for (const auto& scan : log.scans) stamps.push_back(scan.scan.stamp);
  EXPECT_THAT(stamps, ElementsAre(1.0, 1.0, 2.0, 3.0, 4.0, 4.0, 8.0));
  EXPECT_THAT(log.warnings, ElementsAre(AllOf(HasSubstr("later than those of the scans after them"),
                                              HasSubstr(": 3"))));
}

TEST(CarmenLog, CutsByStamps) {
  LogRequest request;
  request.begin = 10.2;
  const Log log = read(kSmallLog, request);
  ASSERT_EQ(log.scans.size(), 1U);
  EXPECT_DOUBLE_EQ(log.scans[0].scan.stamp, 10.2);
}

}  // namespace
}  // namespace adaptive_localization
