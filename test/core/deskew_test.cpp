// SPDX-License-Identifier: BSD-3-Clause
// Scans that take time, by a robot that moves meanwhile.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr double kDuration = 0.1;  // s, a slow laser

Pose2 motionIn(const BaseVelocity& velocity, double seconds) {
  return {velocity.x * seconds, velocity.y * seconds, velocity.turn * seconds};
}

/// Beam after beam, each from where the robot is by then.
LaserScan sweep(const std::shared_ptr<const OccupancyGrid>& map, const Pose2& T_map_base,
                const BaseVelocity& velocity) {
  const ToyLaser laser;
  LaserScan scan = laser.read(map, T_map_base);
  scan.time_increment = kDuration / (laser.beams - 1);
  const RayCaster caster(map);
  for (int i = 0; i < laser.beams; ++i) {
    const Pose2 T_base_beam{0.0, 0.0, scan.angle_min + i * scan.angle_increment};
    const Pose2 T_map_now = T_map_base * motionIn(velocity, i * scan.time_increment);
    const double range = caster.range(T_map_now * T_base_beam, laser.max_range);
    scan.ranges[static_cast<std::size_t>(i)] = static_cast<float>(range);
  }
  return scan;
}

/// Root mean square distance of the end points to the nearest obstacle, were the robot there.
double misfit(const Scan& scan, const Pose2& T_map_base, const DistanceField& field) {
  double sum = 0.0;
  for (int i = 0; i < scan.hits(); ++i) {
    const double distance = field.at(T_map_base * Eigen::Vector2d(scan.x[i], scan.y[i]));
    sum += distance * distance;
  }
  return std::sqrt(sum / scan.hits());
}

TEST(Deskew, PutsTheWallsOfATurningRobotWhereTheyAre) {
  const auto map = asymmetricWorld();
  const DistanceField field(*map);
  const BaseVelocity velocity{0.4, 0.0, 1.5};
  ScanOptions options;
  for (const double yaw : {0.0, 1.0, 2.5, -2.0}) {
    const Pose2 T_map_base{2.5, 1.2, yaw};
    const LaserScan scan = sweep(map, T_map_base, velocity);
    options.deskew = true;
    const double with = misfit(toScan(scan, LaserMount{}, options, velocity), T_map_base, field);
    options.deskew = false;
    const double without = misfit(toScan(scan, LaserMount{}, options, velocity), T_map_base, field);
    EXPECT_LT(with, 0.05) << yaw;
    EXPECT_GT(without, 2.0 * with) << yaw;
  }
}

TEST(Deskew, TurnsNoReturnsAsWell) {
  LaserScan scan;
  scan.angle_increment = 0.5;
  scan.time_increment = 0.1;
  scan.range_max = 10.0;
  scan.ranges = {1.0F, std::numeric_limits<float>::infinity(), 2.0F};
  const Scan turned = toScan(scan, LaserMount{}, ScanOptions{}, {0.0, 0.0, 1.0});
  EXPECT_NEAR(turned.bearing[0], 0.0, 1e-6);
  EXPECT_NEAR(turned.no_return_bearing[0], 0.6, 1e-6);
  EXPECT_NEAR(turned.bearing[1], 1.2, 1e-6);
  EXPECT_NEAR(turned.x[1], 2.0 * std::cos(1.2), 1e-6);
  EXPECT_NEAR(turned.y[1], 2.0 * std::sin(1.2), 1e-6);
}

TEST(Deskew, LeavesScansAloneThatTakeNoTimeOrAnAbsurdOne) {
  LaserScan scan;
  scan.angle_increment = 0.5;
  scan.range_max = 10.0;
  scan.ranges = {1.0F, 1.0F};
  for (const double increment : {0.0, -0.1, 100.0, std::nan("")}) {
    scan.time_increment = increment;
    EXPECT_EQ(durationOf(scan), 0.0);
    const Scan same = toScan(scan, LaserMount{}, ScanOptions{}, {1.0, 0.0, 1.0});
    EXPECT_NEAR(same.bearing[1], 0.5, 1e-6) << increment;
  }
}

/// Mean heading error of a robot that turns on the spot, in degrees.
double headingError(bool deskew) {
  const auto map = asymmetricWorld();
  const BaseVelocity velocity{0.0, 0.0, 1.5};
  Parameters parameters;
  parameters.set("deskew", OptionValue{deskew});
  Localizer localizer(parameters, map);
  Gaussian2 prior;
  prior.mean = {2.5, 1.2, 0.0};
  prior.covariance.diagonal() << 0.01, 0.01, 0.01;
  localizer.reset(prior);
  double sum = 0.0;
  constexpr int kScans = 60;
  for (int k = 0; k < kScans; ++k) {
    const Pose2 T_odom_base{0.0, 0.0, wrapAngle(velocity.turn * 0.2 * k)};
    const Pose2 T_map_base = prior.mean * T_odom_base;
    const Scan scan =
        toScan(sweep(map, T_map_base, velocity), LaserMount{}, localizer.scanOptions(), velocity);
    const Localization answer = localizer.update(T_odom_base, {0.2 * k, scan});
    sum += std::abs(wrapAngle(answer.T_map_base.theta - T_map_base.theta));
  }
  return sum / kScans * 180.0 / kPi;
}

TEST(Deskew, KeepsTheHeadingOfATurningRobot) {
  const double with = headingError(true);
  const double without = headingError(false);
  EXPECT_LT(with, 1.0);
  EXPECT_GT(without, 2.0 * with);
  RecordProperty("heading_error_deg",
                 "with " + std::to_string(with) + ", without " + std::to_string(without));
}

}  // namespace
}  // namespace adaptive_localization
