// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/eval/experiment_drive.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "toy_experiment.hpp"

namespace adaptive_localization {
namespace {

class Drive : public testing::Test {
 protected:
  std::vector<DriveScan> drive(const std::string& lines, int seed = 1) const {
    const ExperimentCase of_case = toy_.load(lines).cases.front();
    ExperimentDrive drive(loadSite(of_case), of_case, seed);
    std::vector<DriveScan> scans;
    while (auto scan = drive.next()) scans.push_back(std::move(*scan));
    return scans;
  }

  /// The share of the readings that differ between two drives' scan number i.
  static double shareChanged(const DriveScan& a, const DriveScan& b) {
    std::size_t changed = 0;
    for (std::size_t i = 0; i < a.scan.ranges.size(); ++i) {
      changed += a.scan.ranges[i] != b.scan.ranges[i] && !std::isnan(a.scan.ranges[i]);
    }
    return static_cast<double>(changed) / static_cast<double>(a.scan.ranges.size());
  }

  ToyExperiment toy_;
};

TEST_F(Drive, GivesAScanEveryTenthOfASecond) {
  const auto scans = drive("duration: 3\nstart: [1, 0.6, 0]\n");
  ASSERT_EQ(scans.size(), 30U);
  EXPECT_NEAR(scans.front().scan.stamp, 0.1, 1e-9);
  EXPECT_NEAR(scans.back().scan.stamp, 3.0, 1e-9);
  EXPECT_LT(distance(*scans.front().T_map_base, {1.0, 0.6, 0.0}), 0.05);
  EXPECT_GT(distance(*scans.back().T_map_base, *scans.front().T_map_base), 0.3) << "stands still";
  for (const auto& scan : scans) EXPECT_FALSE(scan.is_lifted || scan.put_down);
}

TEST_F(Drive, StartsInTheRegionsAndHeadingsGiven) {
  for (int seed = 1; seed < 30; ++seed) {
    const auto scans = drive(
        "duration: 0.2\nsimulation: {drive: false}\n"
        "start: {regions: [[0.4, 0.4, 1, 1], [4.8, 2.9, 5.2, 3.4]], yaw: [1, 2]}\n",
        seed);
    const Pose2& start = *scans.front().T_map_base;
    EXPECT_TRUE((start.x < 1.0 && start.y < 1.0) || (start.x > 4.8 && start.y > 2.9));
    EXPECT_GE(start.theta, 1.0);
    EXPECT_LE(start.theta, 2.0);
  }
}

TEST_F(Drive, RefusesPlacesWhereTheRobotCannotStand) {
  for (const char* lines : {"duration: 1\nstart: [100, 100, 0]\n",
                            "duration: 3\nevents: [{what: kidnap, at: 1, to: [100, 100, 0]}]\n"}) {
    EXPECT_THAT([&] { drive(lines); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(
                    "place of the robot: got 100, 100, expected one where it can stand")))
        << lines;
  }
  EXPECT_NO_THROW(drive("duration: 1\nstart: [0.1, 0.1, 0]\n")) << "a step beside";
}

TEST_F(Drive, IsInterruptedByKidnapsOfWhichOdometryKnowsNothing) {
  const auto scans = drive(
      "duration: 5\nsimulation: {drive: false, profile: ideal}\nstart: [1, 0.6, 0]\n"
      "events: [{what: kidnap, at: 2, every: 2, to: {farther_than: 2}}]\n");
  ASSERT_EQ(scans.size(), 50U);
  int kidnaps = 0;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const bool has_moved = distance(*scans[i].T_map_base, *scans[i - 1].T_map_base) > 1.9;
    EXPECT_EQ(has_moved, scans[i].put_down.has_value());
    EXPECT_LT(distance(scans[i].T_odom_base, scans[i - 1].T_odom_base), 1e-6);
    kidnaps += has_moved;
    EXPECT_NEAR(scans[i].put_down.value_or(2.0 * kidnaps), 2.0 * kidnaps, 1e-6);
  }
  EXPECT_EQ(kidnaps, 2);
}

TEST_F(Drive, CarriesTheRobotBlindWhileItsGyroTurns) {
  const auto scans = drive(
      "duration: 6\nsimulation: {profile: ideal}\nstart: [1, 0.6, 0]\n"
      "events: [{what: carry, at: 2, for: 1.5, to: [5, 3.2, 2]}]\n");
  std::size_t lifted = 0, down = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (scans[i].is_lifted) lifted = i;
    if (scans[i].put_down) down = i;
  }
  ASSERT_GT(lifted, 0U);
  ASSERT_EQ(down - lifted, 15U);
  EXPECT_NEAR(*scans[down].put_down, 3.5, 1e-6);
  for (std::size_t i = 1; i < scans.size(); ++i) {
    EXPECT_NEAR(scans[i].scan.stamp - scans[i - 1].scan.stamp, 0.1, 1e-6);
    EXPECT_EQ(scans[i].T_map_base.has_value(), i < lifted || i >= down);
  }
  for (const float range : scans[lifted].scan.ranges) EXPECT_LE(range, 0.4F);
  const Pose2 before = *scans[lifted - 1].T_map_base, after = *scans[down].T_map_base;
  const Pose2 odom = between(scans[lifted - 1].T_odom_base, scans[down].T_odom_base);
  EXPECT_LT(distance(after, {5.0, 3.2, 2.0}), 0.1);
  EXPECT_LT(std::hypot(odom.x, odom.y), 0.1);
  EXPECT_NEAR(odom.theta, wrapAngle(after.theta - before.theta), 1e-6);
  const Pose2 later = between(scans[down].T_odom_base, scans.back().T_odom_base);
  EXPECT_LT(distance(later, between(after, *scans.back().T_map_base)), 1e-6)
      << "odometry goes on as it did";
}

TEST_F(Drive, SeesAnythingWhileItIsCarriedIfAskedTo) {
  const auto scans = drive("duration: 4\nevents: [{what: carry, at: 1, for: 2, laser: garbage}]\n");
  int far = 0, invalid = 0;
  for (const auto& scan : scans) {
    if (scan.T_map_base) continue;
    for (const float range : scan.scan.ranges) {
      far += range > 2.0F;
      invalid += std::isnan(range);
    }
  }
  EXPECT_GT(far, 1000);
  EXPECT_GT(invalid, 100);
}

TEST_F(Drive, TellsHeadingsThatAreDisturbedForAWhile) {
  const auto scans = drive(
      "duration: 4\nstart: [1, 0.6, 0]\nsimulation: {imu: true, imu_heading_noise: 0.001, "
      "imu_heading_bias: 0, imu_rate_noise: 0.001, imu_rate_bias: 0}\n"
      "events: [{what: disturb, at: 1, for: 2, turned_by: 1.5}]\n");
  ASSERT_EQ(scans.size(), 40U);
  for (const DriveScan& scan : scans) {
    ASSERT_TRUE(scan.heading && scan.gyro);
    const double at = scan.scan.stamp;
    if (std::abs(at - 1.0) < 0.05 || std::abs(at - 3.0) < 0.05) continue;
    const double error = at > 1.0 && at < 3.0 ? 1.5 : 0.0;
    EXPECT_NEAR(wrapAngle(scan.heading->theta - scan.T_map_base->theta), error, 0.01) << at;
  }
  const double turned = scans.back().gyro->angle - scans.front().gyro->angle;
  const double truly = scans.back().T_map_base->theta - scans.front().T_map_base->theta;
  EXPECT_NEAR(wrapAngle(turned - truly), 0.0, 0.02);
}

TEST_F(Drive, TheGyroscopeTurnsWithARobotThatIsCarried) {
  const auto scans = drive(
      "duration: 5\nstart: [1, 0.6, 0]\n"
      "simulation: {drive: false, imu: true, imu_rate_noise: 0.001, imu_rate_bias: 0}\n"
      "events: [{what: carry, at: 1, for: 2, to: [4, 0.6, 2]}]\n");
  EXPECT_NEAR(scans.back().gyro->angle - scans.front().gyro->angle, 2.0, 0.15);
  EXPECT_EQ(scans.back().gyro->since, scans.front().gyro->since);
}

TEST_F(Drive, KidnapsARobotWithoutALaserToo) {
  const auto scans = drive(
      "duration: 3\nstart: [1, 0.6, 0]\nsimulation: {lasers: 0, drive: false}\n"
      "events: [{what: kidnap, at: 1.5, to: [4, 0.6, 0]}]\n");
  ASSERT_EQ(scans.size(), 30U);
  EXPECT_TRUE(scans.front().scan.ranges.empty());
  EXPECT_NEAR(scans.back().T_map_base->x, 4.0, 0.1);
}

TEST_F(Drive, HasNoHeadingsWithoutACompass) {
  const auto scans = drive("duration: 1\nstart: [1, 0.6, 0]\n");
  EXPECT_FALSE(scans.back().heading);
  EXPECT_FALSE(scans.back().gyro);
}

TEST_F(Drive, SeesNoReflectorWhileTheLaserIsCoveredOrCarried) {
  const auto scans =
      drive("cases: [{label: hall, world: " SOURCE_DIR
            "/maps/symmetric}]\nduration: 6\nstart: [8.5, 2.5, 0]\n"
            "simulation: {drive: false, laser_glare: 0}\n"
            "events: [{what: cover, at: 1, for: 1}, {what: block, at: 3, for: 1, share: 1},\n"
            "         {what: carry, at: 5, for: 0.5, to: [8.5, 2.5, 0]}]\n");
  int bright = 0;
  for (const auto& scan : scans) {
    const double t = scan.scan.stamp;
    ASSERT_EQ(scan.scan.intensities.size(), scan.scan.ranges.size());
    const float most =
        *std::max_element(scan.scan.intensities.begin(), scan.scan.intensities.end());
    const bool is_covered =
        (t > 1.01 && t < 1.95) || (t > 3.01 && t < 3.95) || (t > 5.15 && t < 5.45);
    if (is_covered) {
      EXPECT_EQ(most, 0.0F) << t;
    }
    if (most > 120.0F) ++bright;
  }
  EXPECT_GT(bright, 30);
}

TEST_F(Drive, HasAShareOfTheBeamsBlockedForAWhile) {
  const std::string lines = "duration: 3\nstart: [1, 0.6, 0]\n";
  const auto free = drive(lines);
  for (const std::string pattern : {"scattered", "sector"}) {
    const auto blocked = drive(
        lines + "events: [{what: block, at: 1, for: 1, share: 0.3, pattern: " + pattern + "}]\n");
    ASSERT_EQ(blocked.size(), free.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < free.size(); ++i) {
      const double at = free[i].scan.stamp, changed = shareChanged(free[i], blocked[i]);
      const bool is_free = at < 0.95 || at > 2.05;
      EXPECT_TRUE(!is_free || changed == 0.0) << pattern << " at " << at;
      sum += changed;
      for (std::size_t k = 0; k < free[i].scan.ranges.size(); ++k) {
        if (std::isnan(free[i].scan.ranges[k])) continue;
        EXPECT_LE(blocked[i].scan.ranges[k], free[i].scan.ranges[k]);
      }
    }
    EXPECT_NEAR(sum / 10.0, 0.3, 0.03) << pattern;
  }
}

}  // namespace
}  // namespace adaptive_localization
