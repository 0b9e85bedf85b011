// SPDX-License-Identifier: BSD-3-Clause
#include "heading_messages.hpp"

#include <boost/array.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "adaptive_localization/core/pose2.hpp"
#include "core/refusal.hpp"

namespace adaptive_localization {
namespace {

Eigen::Matrix3d toRotation(const geometry_msgs::Quaternion& message) {
  const Eigen::Quaterniond rotation(message.w, message.x, message.y, message.z);
  const double norm = rotation.norm();
  if (!(norm > 0.5 && norm < 2.0)) reject("length of a quaternion", norm, "about 1");
  return rotation.normalized().toRotationMatrix();
}

Eigen::Matrix3d toMatrix(const boost::array<double, 9>& values) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
}

/// Of z in base, by a covariance about the sensor's axes.
double verticalDeviation(const boost::array<double, 9>& covariance,
                         const Eigen::Matrix3d& R_base_sensor) {
  const Eigen::Vector3d up = R_base_sensor.transpose() * Eigen::Vector3d::UnitZ();
  const double variance = up.dot(toMatrix(covariance) * up);
  if (!(variance >= 0.0 && std::isfinite(variance))) reject("variance", variance, "one from 0 on");
  return std::sqrt(variance);
}

/// The yaw of base, seen from above.
double yawOf(const Eigen::Matrix3d& R_world_base) {
  constexpr double kMostTilt = 45.0 * kPi / 180.0;
  const double up = R_world_base(2, 2);
  if (up < std::cos(kMostTilt)) {
    reject("tilt of the robot in degrees", std::acos(std::fmax(up, -1.0)) * 180.0 / kPi,
           "at most 45: how does the sensor sit on it?");
  }
  return std::atan2(R_world_base(1, 0), R_world_base(0, 0));
}

}  // namespace

Heading headingOf(const sensor_msgs::Imu& message, const Eigen::Matrix3d& R_base_sensor) {
  return {yawOf(toRotation(message.orientation) * R_base_sensor.transpose()),
          verticalDeviation(message.orientation_covariance, R_base_sensor)};
}

Heading headingOf(const sensor_msgs::MagneticField& message, const Eigen::Matrix3d& R_base_sensor) {
  constexpr double kLeast = 1e-7;  // T; the earth's horizontal field has 1e-5 and more
  const Eigen::Vector3d field =
      R_base_sensor *
      Eigen::Vector3d(message.magnetic_field.x, message.magnetic_field.y, message.magnetic_field.z);
  const double strength = std::hypot(field.x(), field.y());
  if (!(strength > kLeast && std::isfinite(strength))) {
    reject("horizontal magnetic field in tesla", strength, "more than 1e-7");
  }
  const Eigen::Matrix3d covariance =
      R_base_sensor * toMatrix(message.magnetic_field_covariance) * R_base_sensor.transpose();
  const Eigen::Vector2d across(-field.y() / strength, field.x() / strength);
  const double variance = across.dot(covariance.topLeftCorner<2, 2>() * across);
  if (!(variance >= 0.0 && std::isfinite(variance))) reject("variance", variance, "one from 0 on");
  return {wrapAngle(kPi / 2.0 - std::atan2(field.y(), field.x())), std::sqrt(variance) / strength};
}

Heading headingOf(const geometry_msgs::QuaternionStamped& message,
                  const Eigen::Matrix3d& R_base_sensor) {
  return {yawOf(toRotation(message.quaternion) * R_base_sensor.transpose()), 0.0};
}

TurnRate turnRateOf(const sensor_msgs::Imu& message, const Eigen::Matrix3d& R_base_sensor) {
  const auto& rates = message.angular_velocity;
  const double rate = (R_base_sensor * Eigen::Vector3d(rates.x, rates.y, rates.z)).z();
  if (!std::isfinite(rate)) reject("turn rate", rate, "a number");
  return {rate, verticalDeviation(message.angular_velocity_covariance, R_base_sensor)};
}

}  // namespace adaptive_localization
