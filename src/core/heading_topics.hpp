// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Where a compass and a gyroscope are heard, live or in a bag.
struct HeadingTopics {
  std::string imu_topic;
  std::string magnetic_field_topic;
  std::string heading_topic;
  double heading_std{0.0};
  double turn_rate_std{0.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("imu_topic", imu_topic, Choices{},
           "Topic of a compass with a gyroscope, or of either (sensor_msgs/Imu); empty: none.");
    option("magnetic_field_topic", magnetic_field_topic, Choices{},
           "Topic of a magnetometer (sensor_msgs/MagneticField); empty: none.");
    option("heading_topic", heading_topic, Choices{},
           "Topic of a compass (geometry_msgs/QuaternionStamped); it needs heading_std, as such "
           "messages have none. Empty: none.");
    option("heading_std", heading_std, Range{0, kPi}, "rad",
           "Standard deviation of a heading; 0: from the message's covariance.");
    option("turn_rate_std", turn_rate_std, Range{0, 10}, "rad/s",
           "Standard deviation of a gyroscope's rate; 0: from the message's covariance.");
  }
};

}  // namespace adaptive_localization
