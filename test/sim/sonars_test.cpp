// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sonars.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace adaptive_localization {
namespace {

/// A wall along x = 2, which goes on for ever.
double wallAhead(const Pose2& T_map_ray, double max_range) {
  const double along = std::cos(T_map_ray.theta);
  const double range = (2.0 - T_map_ray.x) / along;
  return along > 1e-9 && range > 0.0 ? std::min(range, max_range) : max_range;
}

/// Walls along x = 2 and y = 2: a corner of 90 degrees.
double cornerAhead(const Pose2& T_map_ray, double max_range) {
  const Pose2 turned{T_map_ray.y, -T_map_ray.x, wrapAngle(T_map_ray.theta - kPi / 2.0)};
  return std::min(wallAhead(T_map_ray, max_range), wallAhead(turned, max_range));
}

double nothing(const Pose2&, double max_range) {
  return max_range;
}

class ARing : public testing::Test {
 protected:
  ARing() {
    options_.sonar_noise = 0.0;
    options_.sonar_cross_talk = 0.0;
  }

  /// Ranges of one sonar from base at a pose, of so many rounds.
  std::vector<double> ranges(std::size_t sonar, const Pose2& T_map_base, const Sonars::Caster& cast,
                             int rounds = 1) const {
    Sonars sonars(options_, Rng(7));
    std::vector<double> all;
    for (int i = 0; i < 8 * rounds; ++i) {
      for (const Ping& ping : sonars.ping(0.0, T_map_base, cast)) {
        if (ping.sonar == sonar) all.push_back(ping.range);
      }
    }
    return all;
  }

  /// A pose of base from which sonar 3 is at a pose.
  static Pose2 baseFor(const Pose2& T_map_sonar) {
    return T_map_sonar * inverse(Sonars::mounts()[3]);
  }

  SonarsOptions options_;
};

TEST_F(ARing, FiresOneSonarOfTheFrontAndOneOfTheBackAtATime) {
  Sonars sonars(options_, Rng(7));
  std::set<std::size_t> heard;
  for (int i = 0; i < 8; ++i) {
    const auto pings = sonars.ping(0.04 * i, {}, nothing);
    ASSERT_EQ(pings.size(), 2U);
    EXPECT_LT(pings[0].sonar, 8U);
    EXPECT_EQ(pings[1].sonar, pings[0].sonar + 8);
    heard.insert({pings[0].sonar, pings[1].sonar});
  }
  EXPECT_EQ(heard.size(), 16U);
}

TEST_F(ARing, LooksAllRoundTheRobot) {
  for (std::size_t i = 0; i < Sonars::kCount; ++i) {
    const Pose2& mount = Sonars::mounts()[i];
    EXPECT_LT(std::hypot(mount.x, mount.y), 0.3);
    EXPECT_LT(std::abs(wrapAngle(mount.theta - std::atan2(mount.y, mount.x + 0.045))), 0.7) << i;
  }
}

TEST_F(ARing, HearsTheNearestOfAWallInItsCone) {
  EXPECT_NEAR(ranges(3, baseFor({0.5, 0.0, 0.0}), wallAhead)[0], 1.5, 0.02);
  EXPECT_NEAR(ranges(3, baseFor({0.5, 0.0, 0.2}), wallAhead)[0], 1.5, 0.02);
}

TEST_F(ARing, HearsNoWallThatMirrorsItsSoundAway) {
  EXPECT_TRUE(std::isinf(ranges(3, baseFor({0.5, 0.0, 0.9}), wallAhead)[0]));
  options_.sonar_mirror_angle = 1.2;  // a rough wall
  EXPECT_NEAR(ranges(3, baseFor({0.5, 0.0, 0.9}), wallAhead)[0], 1.5 / std::cos(0.9 - 0.262), 0.02);
}

TEST_F(ARing, HearsACornerOfTwoMirrors) {
  options_.sonar_view = 0.3;  // with more, the walls are heard at the cone's sides
  const double to_corner = std::hypot(1.5, 1.5);
  EXPECT_NEAR(ranges(3, baseFor({0.5, 0.5, kPi / 4.0}), cornerAhead)[0], to_corner, 0.05);
}

TEST_F(ARing, HearsAWallBehindAMirrorTooFarAway) {
  options_.sonar_view = 0.02;
  const double to_mirror = 0.5 / std::cos(1.2);
  const double behind = (3.0 - 0.5 * std::tan(1.2)) / std::sin(1.2);
  EXPECT_NEAR(ranges(3, baseFor({1.5, -1.0, 1.2}), cornerAhead)[0], to_mirror + behind, 0.03);
}

TEST_F(ARing, DoesNotHearWhatTwoMirrorsSendPastIt) {
  options_.sonar_view = 0.02;
  EXPECT_TRUE(std::isinf(ranges(3, baseFor({1.5, -1.0, 0.7}), cornerAhead)[0]));
}

TEST_F(ARing, HearsNothingFarAwayAndNothingNearerThanItCan) {
  EXPECT_TRUE(std::isinf(ranges(3, baseFor({-3.5, 0.0, 0.0}), wallAhead)[0]));
  EXPECT_EQ(ranges(3, baseFor({1.97, 0.0, 0.0}), wallAhead)[0], options_.sonar_min_range);
}

TEST_F(ARing, IsNoisyByAShareOfTheRangeToo) {
  options_.sonar_noise = 0.02;
  const auto all = ranges(3, baseFor({0.5, 0.0, 0.0}), wallAhead, 2000);
  double mean = 0.0, square = 0.0;
  for (const double range : all) mean += range / 2000.0;
  for (const double range : all) square += std::pow(range - mean, 2) / 2000.0;
  EXPECT_NEAR(mean, 1.5, 0.02);
  EXPECT_NEAR(std::sqrt(square), 0.035, 0.003);
}

TEST_F(ARing, HearsOthersPingsIfTheyComeFirst) {
  options_.sonar_cross_talk = 0.2;
  const auto all = ranges(3, baseFor({0.5, 0.0, 0.0}), wallAhead, 2000);
  const auto is_foreign = [](double range) { return range < 1.4; };
  const auto foreign = std::count_if(all.begin(), all.end(), is_foreign);
  EXPECT_NEAR(static_cast<double>(foreign), 2000 * 0.2 * 1.4 / 5.0, 30.0);
  EXPECT_LT(*std::max_element(all.begin(), all.end()), 1.7);
}

TEST_F(ARing, TellsAReadingWithWhereItsSonarSits) {
  const SonarReading reading = Sonars(options_, Rng(1)).reading({0.0, 5, 1.25});
  EXPECT_EQ(reading.sonar, 5);
  EXPECT_EQ(reading.range, 1.25);
  EXPECT_EQ(reading.max_range, options_.sonar_max_range);
  EXPECT_EQ(reading.view, options_.sonar_view);
  EXPECT_EQ(reading.T_base_sonar.x, 0.148);
}

}  // namespace
}  // namespace adaptive_localization
