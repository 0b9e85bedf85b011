// SPDX-License-Identifier: BSD-3-Clause
#include "eval/error_bound.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace adaptive_localization {
namespace {

using Eigen::Matrix3d;

constexpr double kStep = 1e-5;  // m or rad

double sigmaOf(const LaserOptions& laser) {
  const double rounding = laser.laser_resolution / std::sqrt(12.0);
  const double sigma = std::hypot(laser.laser_noise, rounding);
  if (sigma > 0.0) return sigma;
  throw std::invalid_argument(
      "option 'laser_noise': got 0 and laser_resolution 0, expected one of them above 0, without "
      "which there is no bound of the error");
}

std::vector<double> bearingsOf(const LaserOptions& laser) {
  std::vector<double> bearings;
  const double view = kPi * (laser.laser_view / 180.0);
  const double increment = view / (laser.laser_beams - 1);
  for (int i = 0; i < laser.laser_beams; ++i) bearings.push_back(-view / 2.0 + i * increment);
  return bearings;
}

/// Covariance of the pose after a motion of wheels whose errors have variance k |travel|
/// (Siegwart and Nourbakhsh 2004, 5.2.4).
Matrix3d moved(const Matrix3d& covariance, const Pose2& before, const Pose2& after,
               const OdometryOptions& odometry) {
  const Pose2 motion = between(before, after);
  const double axle = odometry.odom_axle;
  const double turn = motion.theta;
  const double way = motion.x * std::cos(turn / 2.0) + motion.y * std::sin(turn / 2.0);
  const double c = std::cos(before.theta + turn / 2.0);
  const double s = std::sin(before.theta + turn / 2.0);
  Matrix3d F = Matrix3d::Identity();
  F(0, 2) = -way * s;
  F(1, 2) = way * c;
  Eigen::Matrix<double, 3, 2> by_wheel;  // right, left
  const double aside = way / (2.0 * axle);
  by_wheel << c / 2.0 - aside * s, c / 2.0 + aside * s, s / 2.0 + aside * c, s / 2.0 - aside * c,
      1.0 / axle, -1.0 / axle;
  const Eigen::Vector2d travel(way + turn * axle / 2.0, way - turn * axle / 2.0);
  const Eigen::Vector2d variance = odometry.odom_wheel_noise * travel.cwiseAbs();
  return F * covariance * F.transpose() + by_wheel * variance.asDiagonal() * by_wheel.transpose();
}

}  // namespace

Matrix3d rangeInformation(const World& world, const Pose2& T_map_base, const Pose2& T_base_laser,
                          const std::vector<double>& bearings, double max_range, double sigma) {
  const auto rangeFrom = [&](const Pose2& pose, double bearing) {
    return world.range(pose * T_base_laser * Pose2{0.0, 0.0, bearing}, max_range);
  };
  const auto shifted = [&](int axis, double step) {
    Pose2 pose = T_map_base;
    (axis == 0 ? pose.x : axis == 1 ? pose.y : pose.theta) += step;
    return pose;
  };
  Matrix3d information = Matrix3d::Zero();
  for (const double bearing : bearings) {
    const double range = rangeFrom(T_map_base, bearing);
    bool is_smooth = range < max_range;
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3 && is_smooth; ++axis) {
      const double below = rangeFrom(shifted(axis, -kStep), bearing);
      const double above = rangeFrom(shifted(axis, kStep), bearing);
      slope[axis] = (above - below) / (2.0 * kStep);
      // on one surface the curve is flat at this scale; an edge between makes a step
      is_smooth =
          std::abs(above - 2.0 * range + below) < 0.01 * kStep * (1.0 + std::abs(slope[axis]));
    }
    if (is_smooth) information += slope * slope.transpose() / (sigma * sigma);
  }
  return information;
}

ErrorBound boundOf(const Matrix3d& information) {
  const Matrix3d covariance = information.inverse();
  return {std::sqrt(covariance(0, 0) + covariance(1, 1)), std::sqrt(covariance(2, 2))};
}

DriveBound::DriveBound(std::shared_ptr<const World> world, const LaserOptions& laser,
                       const OdometryOptions& odometry, const Prior& prior)
    : world_(std::move(world)),
      laser_(laser),
      odometry_(odometry),
      sigma_(sigmaOf(laser)),
      bearings_(bearingsOf(laser)),
      information_(anywhere()) {
  const auto* known = std::get_if<Gaussian2>(&prior);
  if (known) information_ += known->covariance.inverse();
}

Matrix3d DriveBound::anywhere() {
  return Eigen::Vector3d(1e-4, 1e-4, 1.0 / (kPi * kPi)).asDiagonal();
}

void DriveBound::predict(const Pose2& T_map_base) {
  if (has_moved_) {
    information_ = moved(information_.inverse(), before_, T_map_base, odometry_).inverse();
  }
  before_ = T_map_base;
  has_moved_ = true;
}

ScanBounds DriveBound::scan(const Pose2& T_map_base) {
  predict(T_map_base);
  const Matrix3d seen = rangeInformation(*world_, T_map_base, laserMounts(laser_).front(),
                                         bearings_, laser_.laser_max_range, sigma_);
  information_ += seen;
  return {boundOf(seen + anywhere()), boundOf(information_)};
}

}  // namespace adaptive_localization
