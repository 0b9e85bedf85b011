// SPDX-License-Identifier: BSD-3-Clause
#include "heading_ear.hpp"

#include <stdexcept>

#include "names.hpp"

namespace adaptive_localization {
namespace {

bool areSame(const std::string& topic, const std::string& wanted) {
  return !wanted.empty() && withoutLeadingSlash(topic) == withoutLeadingSlash(wanted);
}

/// The one that the user gives, else the message's.
double deviationOf(double given, double told, const std::string& option) {
  const double deviation = given > 0.0 ? given : told;
  if (deviation > 0.0) return deviation;
  throw std::invalid_argument(
      "its standard deviation is 0, expected one above 0, in the message or as option '" + option +
      "'");
}

}  // namespace

template <class Message, class Use>
void HeadingEar::use(const std::string& sense, Heard& heard, const Message& message,
                     const Use& how) {
  ++heard.received;
  try {
    const std::string frame = withoutLeadingSlash(message.header.frame_id);
    if (frame.empty()) throw std::invalid_argument("its frame_id is empty");
    how(rotation_of_(frame));
  } catch (const std::exception& error) {  // of tf2 as well
    ++heard.dropped;
    complain_(sense, error.what());
  }
}

template <class Message>
void HeadingEar::hearHeading(const Message& message) {
  use("compass", headings_, message, [&](const Eigen::Matrix3d& R_base_sensor) {
    Heading heading = headingOf(message, R_base_sensor);
    heading.deviation = deviationOf(topics_.heading_std, heading.deviation, "heading_std");
    history_.addHeading(message.header.stamp.toSec(), heading);
  });
}

void HeadingEar::hear(const sensor_msgs::Imu& message) {
  if (hasHeading(message)) hearHeading(message);
  if (!hasTurnRate(message)) return;
  use("gyroscope", rates_, message, [&](const Eigen::Matrix3d& R_base_sensor) {
    const TurnRate turn = turnRateOf(message, R_base_sensor);
    const double deviation = deviationOf(topics_.turn_rate_std, turn.deviation, "turn_rate_std");
    history_.addRate(message.header.stamp.toSec(), turn.rate, deviation);
  });
}

void HeadingEar::hear(const sensor_msgs::MagneticField& message) {
  hearHeading(message);
}

void HeadingEar::hear(const geometry_msgs::QuaternionStamped& message) {
  hearHeading(message);
}

void HeadingEar::hear(const BagMessage& message) {
  if (areSame(message.topic, topics_.imu_topic)) {
    if (const auto imu = message.as<sensor_msgs::Imu>()) hear(*imu);
  } else if (areSame(message.topic, topics_.magnetic_field_topic)) {
    if (const auto field = message.as<sensor_msgs::MagneticField>()) hear(*field);
  } else if (areSame(message.topic, topics_.heading_topic)) {
    if (const auto heading = message.as<geometry_msgs::QuaternionStamped>()) hear(*heading);
  }
}

}  // namespace adaptive_localization
