// SPDX-License-Identifier: BSD-3-Clause
#include "landmark_source.hpp"

#include <boost/make_shared.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "callbacks.hpp"
#include "continuity.hpp"
#include "conversions.hpp"
#include "core/background.hpp"

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kQueue = 50;

}  // namespace

LandmarkSource::LandmarkSource(ros::NodeHandle node, tf2_ros::Buffer& tf, TransformInput& tf_input,
                               const Odometry& odometry, const NodeOptions& options,
                               LandmarkMap known, Callback callback, JumpCallback on_jump)
    : tf_input_(tf_input),
      odometry_(odometry),
      options_(options),
      callback_(std::move(callback)),
      on_jump_(std::move(on_jump)),
      mounts_(node, tf, options.base_frame_id, "Sensor"),
      ear_(options.landmarks, std::move(known),
           [this](const std::string& why) {
             if (complaints_.isDue(why))
               ROS_WARN("Landmark message, or a point of it, dropped: %s", why.c_str());
           }),
      filter_(tf, options.odom_frame_id, kQueue, node) {
  using Message = sensor_msgs::PointCloud::ConstPtr;
  if (options.landmarks.landmark_topic.empty()) return;
  filter_.registerCallback([this](const Message& message) {
    const auto outcome = outcomeOf([&] {
      use(*message);
      return true;
    });
    if (!outcome.value) ear_.drop(outcome.error);
  });
  filter_.registerFailureCallback(
      [this](const Message& message, tf2_ros::filter_failure_reasons::FilterFailureReason) {
        ear_.drop("tf cannot place frame '" + message->header.frame_id + "' in '" +
                  options_.odom_frame_id + "' at its stamp");
      });
  subscriber_ =
      subscribe<sensor_msgs::PointCloud>(node, options.landmarks.landmark_topic, kQueue,
                                         [this](const Message& message) { add(message); });
}

void LandmarkSource::add(const sensor_msgs::PointCloud::ConstPtr& message) {
  checkTime(message->header.stamp);
  if (!ear_.accept(*message)) return;
  const std::string frame = withoutLeadingSlash(message->header.frame_id);
  if (mounts_.lookFor(frame) == LaserMounts::Knowledge::kUnknown) {
    return ear_.drop("neither tf nor robot_description knows where frame '" + frame + "' is");
  }
  const auto held = tf_input_.hold();
  filter_.add(message);
}

void LandmarkSource::checkTime(const ros::Time& stamp) {
  if (ear_.last().isZero() || stamp.isZero()) return;
  const double step = stamp.toSec() - ear_.last().toSec();
  if (step < -kTimeBack) on_jump_(stamp, step);
}

void LandmarkSource::add(const BagMessage& message) {
  if (!ear_.listensTo(message.topic)) return;
  const auto sightings = message.as<sensor_msgs::PointCloud>();
  if (sightings) add(boost::make_shared<const sensor_msgs::PointCloud>(*sightings));
}

/// Throws why the message cannot be placed.
void LandmarkSource::use(const sensor_msgs::PointCloud& message) {
  const ros::Time& stamp = message.header.stamp;
  std::string why;
  const auto T_odom_base = odometry_.at(stamp, &why);
  if (!T_odom_base) throw std::invalid_argument(why);
  const auto frame = withoutLeadingSlash(message.header.frame_id);
  auto picture = ear_.read(message, mounts_.placeOf(frame));
  if (!picture) return;
  newest_[frame] = Placed{*T_odom_base, std::move(*picture)};
  callback_(stamp, *T_odom_base);
}

void LandmarkSource::observe(const Pose2& T_odom_base, Observations& observations) {
  for (const auto& [frame, placed] : newest_) {
    tell(placed.picture, between(T_odom_base, placed.T_odom_base), observations.stamp,
         observations.landmarks);
  }
  newest_.clear();
}

void LandmarkSource::forget() {
  newest_.clear();
  ear_.forget();
  filter_.clear();
}

std::optional<SenseHealth> LandmarkSource::health() const {
  if (options_.landmarks.landmark_topic.empty()) return std::nullopt;
  const double last = ear_.last().isZero() ? std::nan("") : ear_.last().toSec();
  return healthOf("landmarks", ear_.heard(), subscriber_.getTopic(), last);
}

}  // namespace adaptive_localization
