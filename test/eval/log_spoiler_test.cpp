// SPDX-License-Identifier: BSD-3-Clause
#include "eval/log_spoiler.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

constexpr double kPeriod = 0.2;  // s
constexpr double kSide = 4.0;    // m

/// Five scans a second while the robot drives squares at 0.5 m/s and turns at 45 deg/s at their
/// corners; odometry and reference are exact, in frames of their own.
Log squares(int corners) {
  const Pose2 T_map_odom{3.0, 1.0, 0.7};
  const Pose2 ahead{0.5 * kPeriod, 0.0, 0.0}, turn{0.0, 0.0, kPi / 4.0 * kPeriod};
  const int ahead_scans = static_cast<int>(std::lround(kSide / ahead.x));
  Log log;
  Pose2 T_odom_base{1.0, 2.0, 0.3};
  const auto add = [&](const Pose2& motion, int scans) {
    for (int i = 0; i < scans; ++i) {
      LogScan scan;
      scan.scan.stamp = 100.0 + kPeriod * static_cast<double>(log.scans.size());
      scan.scan.ranges = {static_cast<float>(log.scans.size())};  // to know it again
      scan.T_odom_base = T_odom_base;
      scan.T_map_base = T_map_odom * T_odom_base;
      log.scans.push_back(scan);
      T_odom_base = T_odom_base * motion;
    }
  };
  for (int i = 0; i < corners; ++i) {
    add(ahead, ahead_scans);
    add(turn, 10);
  }
  add(ahead, ahead_scans);
  return log;
}

/// By how much odometry turns otherwise from scan to scan, in degrees, where it does.
std::vector<double> slips(const Log& good, const Log& spoiled) {
  std::vector<double> found;
  for (std::size_t i = 1; i < good.scans.size(); ++i) {
    const auto motion = [i](const Log& log) {
      return between(log.scans[i - 1].T_odom_base, log.scans[i].T_odom_base);
    };
    const double degrees = wrapAngle(motion(spoiled).theta - motion(good).theta) * 180.0 / kPi;
    if (std::abs(degrees) > 1e-6) found.push_back(degrees);
    EXPECT_NEAR(distance(motion(spoiled), motion(good)), 0.0, 1e-9) << "only the heading slips";
  }
  return found;
}

double lengthOf(const Log& log) {
  double way = 0.0;
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    way += distance(log.scans[i - 1].T_odom_base, log.scans[i].T_odom_base);
  }
  return way;
}

void expectSameReference(const Log& good, const Log& spoiled) {
  ASSERT_EQ(good.scans.size(), spoiled.scans.size());
  for (std::size_t i = 0; i < good.scans.size(); ++i) {
    EXPECT_THAT(*spoiled.scans[i].T_map_base, PoseNear(*good.scans[i].T_map_base, 0.0, 0.0));
  }
}

TEST(LogSpoiler, SlipsBothWaysInSomeTurns) {
  const Log good = squares(40);
  const Log spoiled = spoil(good, "slip", 7.5, 1);
  const auto found = slips(good, spoiled);
  EXPECT_GT(found.size(), 10U);
  EXPECT_LT(found.size(), 30U);
  int left = 0;
  for (const double degrees : found) {
    EXPECT_GE(std::abs(degrees), 5.0);
    EXPECT_LE(std::abs(degrees), 10.0);
    left += degrees > 0.0;
  }
  EXPECT_GT(left, 2);
  EXPECT_LT(left, static_cast<int>(found.size()) - 2);
  expectSameReference(good, spoiled);
}

TEST(LogSpoiler, SlipTurnsOdometryFromThenOn) {
  const Log good = squares(1);
  const Log spoiled = spoil(good, "slip", 7.5, 1);
  const auto found = slips(good, spoiled);
  ASSERT_EQ(found.size(), 1U);
  const double turned = good.scans.back().T_odom_base.theta + found[0] * kPi / 180.0;
  EXPECT_NEAR(wrapAngle(spoiled.scans.back().T_odom_base.theta - turned), 0.0, 1e-9);
  // the last scan is a step short of the corner
  EXPECT_NEAR(distance(good.scans.back().T_odom_base, spoiled.scans.back().T_odom_base),
              2.0 * (kSide - 0.1) * std::sin(0.5 * std::abs(found[0]) * kPi / 180.0), 1e-6);
  EXPECT_NEAR(distance(good.scans[40].T_odom_base, spoiled.scans[40].T_odom_base), 0.0, 1e-9)
      << "not before the turn";
}

TEST(LogSpoiler, SlipSaysThatThereIsNoTurn) {
  const Log spoiled = spoil(squares(0), "slip", 7.5, 1);
  EXPECT_THAT(slips(squares(0), spoiled), IsEmpty());
  EXPECT_THAT(spoiled.warnings, ElementsAre(HasSubstr("no slips")));
}

TEST(LogSpoiler, ScaleMakesWaysLongerAndLeavesTurns) {
  const Log good = squares(3);
  const Log spoiled = spoil(good, "scale", 0.02, 1);
  EXPECT_NEAR(lengthOf(spoiled) / lengthOf(good), 1.02, 1e-9);
  EXPECT_NEAR(spoiled.scans.back().T_odom_base.theta, good.scans.back().T_odom_base.theta, 1e-9);
  EXPECT_THAT(spoiled.scans[0].T_odom_base, PoseNear(good.scans[0].T_odom_base, 0.0, 0.0));
  expectSameReference(good, spoiled);
}

TEST(LogSpoiler, LostTakesThatShareOfTheScans) {
  const Log good = squares(40);
  const Log spoiled = spoil(good, "lost", 0.3, 1);
  EXPECT_NEAR(static_cast<double>(spoiled.scans.size()) / static_cast<double>(good.scans.size()),
              0.7, 0.03);
  for (const auto& scan : spoiled.scans) {
    const auto& same = good.scans[static_cast<std::size_t>(scan.scan.ranges[0])];
    EXPECT_EQ(scan.scan.stamp, same.scan.stamp);
    EXPECT_THAT(scan.T_odom_base, PoseNear(same.T_odom_base, 0.0, 0.0));
  }
  EXPECT_EQ(spoil(good, "lost", 1.0, 1).scans.size(), 1U) << "the first stays";
}

TEST(LogSpoiler, LatePairsAScanWithLaterOdometry) {
  const Log good = squares(2);
  const Log spoiled = spoil(good, "late", 0.3, 1);
  ASSERT_EQ(spoiled.scans.size(), good.scans.size() - 2) << "no odometry so late";
  for (std::size_t i = 0; i < spoiled.scans.size(); ++i) {
    const LogScan& scan = spoiled.scans[i];
    EXPECT_EQ(scan.scan.ranges[0], static_cast<float>(i)) << "what was seen";
    EXPECT_NEAR(scan.scan.stamp, good.scans[i].scan.stamp + 0.3, 1e-9);
    // a scan and a half on
    const auto& from = good.scans[i + 1];
    const auto& to = good.scans[i + 2];
    EXPECT_THAT(scan.T_odom_base,
                PoseNear(interpolate(from.T_odom_base, to.T_odom_base, 0.5), 1e-6, 1e-6));
    EXPECT_THAT(*scan.T_map_base,
                PoseNear(interpolate(*from.T_map_base, *to.T_map_base, 0.5), 1e-6, 1e-6))
        << "the truth at the stamp";
  }
}

TEST(LogSpoiler, ScansThatAreStampedAnewTakeTheOdometryOfTheirNewStamps) {
  const Log good = squares(2);
  const Log early = restamped(good, -0.2);
  ASSERT_EQ(early.scans.size(), good.scans.size() - 1) << "no odometry so early";
  EXPECT_EQ(early.scans[0].scan.ranges[0], 1.0F);
  EXPECT_THAT(early.scans[0].T_odom_base, PoseNear(good.scans[0].T_odom_base, 1e-6, 1e-6));
  EXPECT_THAT(*early.scans[5].T_map_base, PoseNear(*good.scans[5].T_map_base, 1e-6, 1e-6));
  const Log mended = restamped(spoil(good, "late", 0.2, 1), -0.2);
  for (const LogScan& scan : mended.scans) {
    const LogScan& known = good.scans[static_cast<std::size_t>(scan.scan.ranges[0])];
    EXPECT_THAT(scan.T_odom_base, PoseNear(known.T_odom_base, 1e-6, 1e-6));
  }
  EXPECT_TRUE(restamped(good, 1e6).scans.empty());
  EXPECT_TRUE(restamped({}, 1.0).scans.empty());
}

TEST(LogSpoiler, LateKeepsScansWithoutReferenceWithout) {
  Log log = squares(0);
  log.scans[3].T_map_base.reset();
  const Log spoiled = spoil(log, "late", 0.1, 1);
  EXPECT_FALSE(spoiled.scans[3].T_map_base);
  EXPECT_TRUE(spoiled.scans[4].T_map_base);
}

TEST(LogSpoiler, ThinKeepsAScanPerMetre) {
  const Log good = squares(5);
  const Log spoiled = spoil(good, "thin", 1.0, 1);
  EXPECT_NEAR(static_cast<double>(spoiled.scans.size()), 6 * kSide, 2.0);
  EXPECT_EQ(spoiled.scans[0].scan.ranges[0], 0.0F);
  for (std::size_t i = 1; i < spoiled.scans.size(); ++i) {
    const auto number = [&](std::size_t k) {
      return static_cast<std::size_t>(spoiled.scans[k].scan.ranges[0]);
    };
    Log part;
    part.scans.assign(good.scans.begin() + static_cast<long>(number(i - 1)),
                      good.scans.begin() + static_cast<long>(number(i)) + 1);
    EXPECT_NEAR(lengthOf(part), 1.05, 0.06);
  }
}

TEST(LogSpoiler, CarriedDrivesPiecesInAnotherOrderAndOdometryKnowsNothing) {
  const Log good = squares(10);
  const Log spoiled = spoil(good, "carried", 10.0, 1);
  ASSERT_EQ(spoiled.scans.size(), good.scans.size());
  std::set<float> seen;
  int carried = 0;
  for (std::size_t i = 0; i < spoiled.scans.size(); ++i) {
    const LogScan& scan = spoiled.scans[i];
    const auto& same = good.scans[static_cast<std::size_t>(scan.scan.ranges[0])];
    seen.insert(scan.scan.ranges[0]);
    EXPECT_NEAR(scan.scan.stamp, good.scans[i].scan.stamp, 1e-6) << "one after the other";
    EXPECT_THAT(*scan.T_map_base, PoseNear(*same.T_map_base, 0.0, 0.0)) << "stays true";
    if (i == 0) continue;
    const LogScan& before = spoiled.scans[i - 1];
    const Pose2 by_odometry = between(before.T_odom_base, scan.T_odom_base);
    const Pose2 true_motion = between(*before.T_map_base, *scan.T_map_base);
    if (distance(by_odometry, Pose2{}) < 1e-9 && std::abs(by_odometry.theta) < 1e-9) {
      ++carried;  // it never rests otherwise
    } else {
      EXPECT_EQ(scan.scan.ranges[0], before.scan.ranges[0] + 1.0F);
      EXPECT_THAT(by_odometry, PoseNear(true_motion, 1e-9, 1e-9));
    }
  }
  EXPECT_EQ(seen.size(), good.scans.size()) << "each scan once";
  EXPECT_EQ(spoiled.scans[0].scan.ranges[0], 0.0F) << "from the start";
  EXPECT_EQ(carried, 10) << "110 s";
}

TEST(LogSpoiler, CarriedSaysThatTheLogIsTooShortForIt) {
  EXPECT_THAT(spoil(squares(0), "carried", 30.0, 1).warnings,
              ElementsAre(HasSubstr("not carried")));
}

TEST(LogSpoiler, ASeedGivesTheSameLogAndAnotherAnother) {
  const Log good = squares(10);
  const auto odometryOf = [](const Log& log) {
    std::vector<double> all;
    for (const auto& scan : log.scans) {
      all.insert(all.end(), {scan.scan.stamp, scan.T_odom_base.x, scan.T_odom_base.theta});
    }
    return all;
  };
  for (const auto& damage : logDamages()) {
    const auto with = [&](std::uint64_t seed) {
      return odometryOf(spoil(good, damage.kind.name, damage.kind.amount, seed));
    };
    EXPECT_EQ(with(7), with(7)) << damage.kind.name;
    EXPECT_NE(with(7), odometryOf(good)) << damage.kind.name;
    const std::set<std::string> random{"slip", "lost", "carried"};
    EXPECT_EQ(with(7) != with(8), random.count(damage.kind.name) > 0) << damage.kind.name;
  }
}

TEST(LogSpoiler, RefusesUnknownKindsAndAmountsAndToTakeAll) {
  EXPECT_THAT([] { spoil(squares(0), "thick", 0.1, 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(
                  "got 'thick', expected one of slip, scale, lost, late, thin, carried")));
  EXPECT_THAT([] { spoil(squares(0), "lost", 1.5, 1); },
              ThrowsMessage<std::invalid_argument>("damage 'lost': got 1.5, expected 0 to 1"));
  EXPECT_THAT([] { spoil(squares(0), "late", 10.0, 1); },
              ThrowsMessage<std::invalid_argument>("damage 'late': no scan of the log is left"));
}

}  // namespace
}  // namespace adaptive_localization
