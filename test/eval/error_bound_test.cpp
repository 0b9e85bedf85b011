// SPDX-License-Identifier: BSD-3-Clause
#include "eval/error_bound.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

namespace adaptive_localization {
namespace {

constexpr double kSigma = 0.03;  // m

std::shared_ptr<const World> room(double width, double height) {
  FloorPlan plan;
  plan.outline = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  return makeWorld(plan, false);
}

std::vector<double> allRound(int beams) {
  std::vector<double> bearings;
  for (int i = 0; i < beams; ++i) bearings.push_back(2.0 * kPi * (i + 0.5) / beams - kPi);
  return bearings;
}

/// Of one beam that meets a wall with unit normal n at angle a from it: the range's derivatives are
/// -n / cos a by place, and by heading range * tan a.
Eigen::Matrix3d ofBeam(const Eigen::Vector2d& normal, const Eigen::Vector2d& ray, double range) {
  const double along = normal.dot(ray);
  const double across = ray.x() * normal.y() - ray.y() * normal.x();
  const Eigen::Vector3d slope(-normal.x() / along, -normal.y() / along, -range * across / along);
  return slope * slope.transpose() / (kSigma * kSigma);
}

TEST(ErrorBound, IsTheClosedFormInASquareRoom) {
  constexpr double kHalf = 2.0;
  const auto bearings = allRound(176);  // none into a corner
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  for (const double bearing : bearings) {
    const Eigen::Vector2d ray(std::cos(bearing), std::sin(bearing));
    const bool sideways = std::abs(ray.x()) > std::abs(ray.y());
    const Eigen::Vector2d normal = sideways ? Eigen::Vector2d(ray.x() > 0.0 ? 1.0 : -1.0, 0.0)
                                            : Eigen::Vector2d(0.0, ray.y() > 0.0 ? 1.0 : -1.0);
    expected += ofBeam(normal, ray, kHalf / normal.dot(ray));
  }
  const auto information = rangeInformation(*room(2 * kHalf, 2 * kHalf), {kHalf, kHalf, 0.0}, {},
                                            bearings, 80.0, kSigma);
  EXPECT_LT((information - expected).norm(), 1e-4 * expected.norm());
  EXPECT_NEAR(information(0, 1), 0.0, 1e-3 * information(0, 0)) << "four walls the same";
  EXPECT_NEAR(information(0, 0), information(1, 1), 1e-3 * information(0, 0));
}

TEST(ErrorBound, TurnsWithTheRobotAndItsLaser) {
  const auto world = room(4.0, 3.0);
  const auto bearings = allRound(360);
  const Pose2 T_base_laser{0.2, 0.1, 0.0};
  const auto straight = rangeInformation(*world, {1.5, 1.0, 0.0}, {}, bearings, 80.0, kSigma);
  const auto turned = rangeInformation(*world, {1.5, 1.0, kPi / 2.0}, {}, bearings, 80.0, kSigma);
  EXPECT_LT((straight - turned).norm(), 0.02 * straight.norm());
  // The same laser's place, so the same knowledge of it, which the lever takes to the base.
  const auto mounted = rangeInformation(*world, Pose2{1.5, 1.0, 0.0} * inverse(T_base_laser),
                                        T_base_laser, bearings, 80.0, kSigma);
  Eigen::Matrix3d lever = Eigen::Matrix3d::Identity();
  lever(0, 2) = -0.1;
  lever(1, 2) = 0.2;
  EXPECT_LT((mounted - lever.transpose() * straight * lever).norm(), 1e-6 * mounted.norm());
}

TEST(ErrorBound, HasOneUnobservableDirectionInACorridor) {
  const auto world = room(200.0, 2.0);
  const auto information =
      rangeInformation(*world, {100.0, 1.0, 0.0}, {}, allRound(360), 8.0, kSigma);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information);
  EXPECT_NEAR(solver.eigenvalues()[0], 0.0, 1e-6 * solver.eigenvalues()[1]);
  EXPECT_NEAR(std::abs(solver.eigenvectors().col(0).x()), 1.0, 1e-6) << "along it";
  EXPECT_GT(solver.eigenvalues()[1], 1e4);
}

TEST(ErrorBound, LearnsNothingFromBeamsThatSeeNothingOrAnEdge) {
  const auto nothing =
      rangeInformation(*room(100.0, 100.0), {50.0, 50.0, 0.0}, {}, allRound(90), 8.0, kSigma);
  EXPECT_EQ(nothing.norm(), 0.0);
  // A beam into a corner: its two sides slope differently.
  const auto corner =
      rangeInformation(*room(4.0, 4.0), {2.0, 2.0, 0.0}, {}, {kPi / 4.0}, 8.0, kSigma);
  EXPECT_EQ(corner.norm(), 0.0);
}

LaserOptions noisyLaser() {
  LaserOptions laser;
  laser.laser_noise = kSigma;
  laser.laser_resolution = 0.0;
  return laser;
}

TEST(ErrorBound, FallsAsScansComeInWhereARobotStands) {
  DriveBound bound(room(4.0, 3.0), noisyLaser(), {}, Anywhere{});
  const Pose2 pose{1.0, 1.2, 0.3};
  const ScanBounds first = bound.scan(pose);
  const double alone = first.of_scan.position;
  EXPECT_NEAR(first.of_drive.position, alone, 1e-4 * alone);
  for (int i = 2; i < 16; ++i) bound.scan(pose);
  const ScanBounds last = bound.scan(pose);
  EXPECT_NEAR(last.of_drive.position, alone / 4.0, 1e-3 * alone) << "one over root n";
  EXPECT_DOUBLE_EQ(last.of_scan.position, alone);
  bound.restart();
  EXPECT_NEAR(bound.scan(pose).of_drive.position, alone, 1e-4 * alone) << "the past is of no use";
}

TEST(ErrorBound, GrowsWithTheWheelsNoiseOnTheWay) {
  LaserOptions blind = noisyLaser();
  blind.laser_max_range = 1.0;
  OdometryOptions odometry;
  odometry.odom_wheel_noise = 1e-4;
  Gaussian2 known;
  known.covariance = 1e-12 * Eigen::Matrix3d::Identity();
  DriveBound bound(room(100.0, 100.0), blind, odometry, known);
  ErrorBound end;
  for (int i = 0; i <= 100; ++i) end = bound.scan({40.0 + 0.1 * i, 50.0, 0.0}).of_drive;
  const double way = 10.0, k = 1e-4, axle = 0.33;
  const double heading_variance = 2.0 * k * way / (axle * axle);
  EXPECT_NEAR(end.heading, std::sqrt(heading_variance), 1e-4);
  const double ahead = k * way / 2.0;
  const double aside = heading_variance * way * way / 3.0;  // the integral of s^2
  EXPECT_NEAR(end.position, std::sqrt(ahead + aside), 1e-3);
}

TEST(ErrorBound, CountsRoundingAsNoiseAndNeedsSome) {
  LaserOptions laser = noisyLaser();
  laser.laser_noise = 0.0;
  EXPECT_THROW(DriveBound(room(4, 3), laser, {}, Anywhere{}), std::invalid_argument);
  laser.laser_resolution = kSigma * std::sqrt(12.0);
  DriveBound rounded(room(4.0, 3.0), laser, {}, Anywhere{});
  DriveBound noisy(room(4.0, 3.0), noisyLaser(), {}, Anywhere{});
  const Pose2 pose{1.0, 1.0, 0.0};
  EXPECT_NEAR(rounded.scan(pose).of_scan.position, noisy.scan(pose).of_scan.position, 1e-12);
}

}  // namespace
}  // namespace adaptive_localization
