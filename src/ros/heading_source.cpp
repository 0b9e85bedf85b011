// SPDX-License-Identifier: BSD-3-Clause
#include "heading_source.hpp"

#include <cmath>

#include "callbacks.hpp"

namespace adaptive_localization {

HeadingSource::HeadingSource(ros::NodeHandle node, tf2_ros::Buffer& tf, const Odometry& odometry,
                             const NodeOptions& options)
    : odometry_(odometry),
      options_(options),
      mounts_(node, tf, options.base_frame_id, "Sensor"),
      ear_(
          options.headings,
          [this](const std::string& frame) -> Eigen::Matrix3d {
            return mounts_.placeOf(frame).linear();
          },
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
  const HeadingTopics& wanted = options_.headings;
  const bool has_compass = !wanted.magnetic_field_topic.empty() || !wanted.heading_topic.empty();
  const bool has_imu = !wanted.imu_topic.empty();  // with a compass, a gyroscope or both
  const bool is_heard = ear_.headings().received > 0 || ear_.rates().received > 0;
  std::vector<SenseHealth> all;
  if (has_compass || (has_imu && (ear_.headings().received > 0 || !is_heard))) {
    all.push_back(healthOf("compass", ear_.headings(), topics(), ear_.history().lastHeading()));
  }
  if (has_imu && ear_.rates().received > 0) {
    all.push_back(healthOf("gyroscope", ear_.rates(), topics(), ear_.history().lastRate()));
  }
  return all;
}

std::string HeadingSource::topics() const {
  std::string names;
  for (const auto& subscriber : subscribers_) {
    names += (names.empty() ? "" : ", ") + subscriber.getTopic();
  }
  return names;
}

}  // namespace adaptive_localization
