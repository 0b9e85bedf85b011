// SPDX-License-Identifier: BSD-3-Clause
#include "landmark_source.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "../bag/sighting_messages.hpp"
#include "adaptive_localization/core/background.hpp"
#include "callbacks.hpp"
#include "conversions.hpp"
#include "stamps.hpp"

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kQueue = 50;

/// A landmark as seen from where the robot is now.
Sighting seenFrom(const Pose2& T_now_then, Sighting sighting) {
  const Eigen::Vector2d point =
      T_now_then * Eigen::Vector2d(sighting.range * std::cos(sighting.bearing),
                                   sighting.range * std::sin(sighting.bearing));
  sighting.range = point.norm();
  sighting.bearing = std::atan2(point.y(), point.x());
  return sighting;
}

}  // namespace

LandmarkSource::LandmarkSource(ros::NodeHandle node, tf2_ros::Buffer& tf, TransformInput& tf_input,
                               const Odometry& odometry, const NodeOptions& options,
                               LandmarkMap known, Callback callback)
    : tf_input_(tf_input),
      odometry_(odometry),
      options_(options),
      known_(std::move(known)),
      callback_(std::move(callback)),
      mounts_(node, tf, options.base_frame_id, "Sensor"),
      filter_(tf, options.odom_frame_id, kQueue, node) {
  using Message = sensor_msgs::PointCloud::ConstPtr;
  if (options.landmark_topic.empty()) return;
  if (known_.all().empty()) {
    throw std::invalid_argument("option 'landmark_topic': got '" + options.landmark_topic +
                                "' without a landmark_map, expected both");
  }
  filter_.registerCallback([this](const Message& message) {
    const auto outcome = outcomeOf([&] {
      use(*message);
      return true;
    });
    if (!outcome.value) drop(outcome.error);
  });
  filter_.registerFailureCallback(
      [this](const Message& message, tf2_ros::filter_failure_reasons::FilterFailureReason) {
        drop("tf cannot place frame '" + message->header.frame_id + "' in '" +
             options_.odom_frame_id + "' at its stamp");
      });
  subscriber_ = subscribe<sensor_msgs::PointCloud>(
      node, options.landmark_topic, kQueue, [this](const Message& message) { add(message); });
}

void LandmarkSource::add(const sensor_msgs::PointCloud::ConstPtr& message) {
  ++heard_.received;
  const std::string frame = withoutLeadingSlash(message->header.frame_id);
  if (frame.empty()) return drop("its frame_id is empty");
  if (!leavesRoom(message->header.stamp)) return drop("its stamp is out of range");
  if (message->header.stamp <= last_) return drop("its stamp does not come after the last one");
  if (mounts_.lookFor(frame) == LaserMounts::Knowledge::kUnknown) {
    return drop("neither tf nor robot_description knows where frame '" + frame + "' is");
  }
  const auto held = tf_input_.hold();
  filter_.add(message);
}

/// Throws whatever is wrong with the message.
void LandmarkSource::use(const sensor_msgs::PointCloud& message) {
  const ros::Time& stamp = message.header.stamp;
  std::string why;
  const auto T_odom_base = odometry_.at(stamp, &why);
  if (!T_odom_base) throw std::invalid_argument(why);
  const auto T_base_sensor = mounts_.placeOf(withoutLeadingSlash(message.header.frame_id));
  Picture picture{stamp, *T_odom_base, {}};
  for (const Sighting& sighting :
       toSightings(message, T_base_sensor, [this](const std::string& what) { drop(what); })) {
    if (isKnown(sighting)) {
      picture.sightings.push_back(sighting);
    } else {
      drop("id of a landmark: got " + std::to_string(sighting.id) + ", which is not in the map");
    }
  }
  last_ = stamp;
  picture_ = std::move(picture);
  callback_(stamp, *T_odom_base);
}

bool LandmarkSource::isKnown(const Sighting& sighting) const {
  return !known_.candidates(sighting.id).empty();
}

void LandmarkSource::drop(const std::string& why) {
  ++heard_.dropped;
  if (complaints_.isDue(why))
    ROS_WARN("Landmark message, or a point of it, dropped: %s", why.c_str());
}

void LandmarkSource::observe(const Pose2& T_odom_base, Observations& observations) {
  constexpr double kOld = 0.5;  // s
  const auto picture = std::exchange(picture_, std::nullopt);
  if (!picture || std::abs(observations.stamp - picture->stamp.toSec()) > kOld) return;
  const Pose2 T_now_then = between(T_odom_base, picture->T_odom_base);
  if (!observations.landmarks) observations.landmarks.emplace();
  for (const Sighting& sighting : picture->sightings) {
    observations.landmarks->push_back(seenFrom(T_now_then, sighting));
  }
}

void LandmarkSource::forget() {
  picture_.reset();
  last_ = {};
  filter_.clear();
}

std::optional<SenseHealth> LandmarkSource::health() const {
  if (options_.landmark_topic.empty()) return std::nullopt;
  const double last = last_.isZero() ? std::nan("") : last_.toSec();
  return healthOf("landmarks", heard_, subscriber_.getTopic(), last);
}

}  // namespace adaptive_localization
