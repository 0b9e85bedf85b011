// SPDX-License-Identifier: BSD-3-Clause
#include "simulator_messages.hpp"

#include <cmath>

#include "../bag/sighting_messages.hpp"
#include "conversions.hpp"

namespace adaptive_localization {

nav_msgs::Odometry toMessage(const Pose2& pose, const Velocity& velocity) {
  nav_msgs::Odometry message;
  message.pose.pose = toPoseMessage(pose);
  message.twist.twist.linear.x = velocity.forward;
  message.twist.twist.linear.y = velocity.aside;
  message.twist.twist.angular.z = velocity.turn;
  return message;
}

sensor_msgs::Imu toMessage(const ImuReading& reading) {
  const auto square = [](double value) { return value * value; };
  sensor_msgs::Imu message;
  message.orientation = toPoseMessage({0.0, 0.0, reading.heading.theta}).orientation;
  message.angular_velocity.z = reading.rate;
  message.linear_acceleration_covariance[0] = -1.0;
  for (const std::size_t axis : {0U, 4U, 8U}) {
    message.orientation_covariance[axis] = square(reading.heading.deviation);
    message.angular_velocity_covariance[axis] = square(reading.rate_deviation);
  }
  return message;
}

sensor_msgs::PointCloud toMessage(const Picture& picture) {
  sensor_msgs::PointCloud message = noSightings();
  for (const Sighting& sighting : picture.sightings) {
    const Eigen::Vector3d place(sighting.range * std::cos(sighting.bearing),
                                sighting.range * std::sin(sighting.bearing), 0.0);
    addSighting(message, place, sighting.id, sighting.range_deviation, sighting.bearing_deviation);
  }
  return message;
}

sensor_msgs::Range toMessage(const SonarReading& reading) {
  sensor_msgs::Range message;
  message.radiation_type = sensor_msgs::Range::ULTRASOUND;
  message.field_of_view = static_cast<float>(reading.view);
  message.max_range = static_cast<float>(reading.max_range);
  message.range = static_cast<float>(reading.range);
  return message;
}

}  // namespace adaptive_localization
