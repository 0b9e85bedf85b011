// SPDX-License-Identifier: BSD-3-Clause
#include "heading_source.hpp"

#include <cmath>
#include <stdexcept>

#include "callbacks.hpp"

namespace adaptive_localization {

HeadingSource::HeadingSource(ros::NodeHandle node, tf2_ros::Buffer& tf, const Odometry& odometry,
                             const NodeOptions& options)
    : tf_(tf),
      odometry_(odometry),
      options_(options),
      mounts_(node, tf, options.base_frame_id, "Sensor"),
      ear_(
          options.headings, [this](const std::string& frame) { return rotationOf(frame); },
          [this](const std::string& sense, const std::string& why) {
            if (complaints_.isDue(sense + why)) {
              ROS_WARN("Message of the %s dropped: %s", sense.c_str(), why.c_str());
            }
          }) {
  listen<sensor_msgs::Imu>(node, options.headings.imu_topic);
  listen<sensor_msgs::MagneticField>(node, options.headings.magnetic_field_topic);
  listen<geometry_msgs::QuaternionStamped>(node, options.headings.heading_topic);
}

template <class Message>
void HeadingSource::listen(ros::NodeHandle& node, const std::string& topic) {
  constexpr std::uint32_t kQueue = 200;
  if (topic.empty()) return;
  subscribers_.push_back(subscribe<Message>(node, topic, kQueue,
                                            [this](const auto& message) { ear_.hear(*message); }));
}

/// Throws std::exception saying why if nobody knows.
Eigen::Matrix3d HeadingSource::rotationOf(const std::string& frame) {
  if (mounts_.lookFor(frame) != LaserMounts::Knowledge::kKnown) {
    throw std::invalid_argument("neither tf nor robot_description knows where frame '" + frame +
                                "' is");
  }
  const auto q =
      tf_.lookupTransform(options_.base_frame_id, frame, ros::Time(0)).transform.rotation;
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
}

void HeadingSource::observe(const Pose2& T_odom_base, Observations& observations) const {
  observations.gyro = ear_.history().turnAt(observations.stamp);
  const auto reading = ear_.history().headingAt(observations.stamp);
  if (!reading) return;
  observations.heading = reading->heading;
  const auto T_odom_then = odometry_.at(ros::Time(reading->stamp));
  if (!T_odom_then) return;
  const double turned = wrapAngle(T_odom_base.theta - T_odom_then->theta);
  observations.heading->theta = wrapAngle(reading->heading.theta + turned);
}

std::vector<SenseHealth> HeadingSource::health() const {
  const HeadingTopics& topics = options_.headings;
  const bool has_compass = !topics.magnetic_field_topic.empty() || !topics.heading_topic.empty();
  const bool has_imu = !topics.imu_topic.empty();  // with a compass, a gyroscope or both
  const bool is_heard = ear_.headings().received > 0 || ear_.rates().received > 0;
  std::vector<SenseHealth> all;
  if (has_compass || (has_imu && (ear_.headings().received > 0 || !is_heard))) {
    all.push_back(healthOf("compass", ear_.headings(), ear_.history().lastHeading()));
  }
  if (has_imu && ear_.rates().received > 0) {
    all.push_back(healthOf("gyroscope", ear_.rates(), ear_.history().lastRate()));
  }
  return all;
}

SenseHealth HeadingSource::healthOf(const std::string& name, const Heard& heard,
                                    double last) const {
  constexpr double kSilence = 1.0;  // s
  SenseHealth health{name, heard, ""};
  if (heard.received == 0) {
    for (const auto& subscriber : subscribers_) {
      health.missing +=
          (health.missing.empty() ? "nothing heard on " : ", ") + subscriber.getTopic();
    }
  } else if (!std::isfinite(last)) {
    health.missing = "no message can be used";
  } else if (const double silent = ros::Time::now().toSec() - last; silent > kSilence) {
    health.missing = "silent for " + std::to_string(std::lround(silent)) + " s";
  }
  return health;
}

}  // namespace adaptive_localization
