// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/QuaternionStamped.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/MagneticField.h>

#include <Eigen/Geometry>

#include "adaptive_localization/core/observations.hpp"

namespace adaptive_localization {

/// A turn rate of base about the vertical with its standard deviation, rad/s.
struct TurnRate {
  double rate{0.0};
  double deviation{0.0};
};

/// A message says by -1 in front of a covariance that it does not have the quantity.
inline bool hasHeading(const sensor_msgs::Imu& message) {
  return message.orientation_covariance[0] != -1.0;
}
inline bool hasTurnRate(const sensor_msgs::Imu& message) {
  return message.angular_velocity_covariance[0] != -1.0;
}

// What messages of compasses and gyroscopes tell of base, R_base_sensor being how the sensor sits
// on it. Deviations are those of the messages: 0 where a message leaves them open. All throw
// std::invalid_argument naming what is wrong: numbers that are not finite, no rotation, a robot
// that lies on its side, a field without a horizontal part.

/// The yaw of base in the frame in which the orientation is given.
Heading headingOf(const sensor_msgs::Imu& message, const Eigen::Matrix3d& R_base_sensor);

/// Yaw counter-clockwise from east, by the horizontal part of the field, which points north.
Heading headingOf(const sensor_msgs::MagneticField& message, const Eigen::Matrix3d& R_base_sensor);

/// The yaw of base. The message has no deviation.
Heading headingOf(const geometry_msgs::QuaternionStamped& message,
                  const Eigen::Matrix3d& R_base_sensor);

TurnRate turnRateOf(const sensor_msgs::Imu& message, const Eigen::Matrix3d& R_base_sensor);

}  // namespace adaptive_localization
