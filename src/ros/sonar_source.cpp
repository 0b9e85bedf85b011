// SPDX-License-Identifier: BSD-3-Clause
#include "sonar_source.hpp"

#include <topic_tools/shape_shifter.h>

#include <cmath>

#include "../bag/stamps.hpp"
#include "callbacks.hpp"
#include "continuity.hpp"

namespace adaptive_localization {
namespace {

constexpr double kOld = 1.0;           // s, of a reading that nobody asked for
constexpr std::uint32_t kQueue = 200;  // messages, on a topic and waiting for tf

/// What came on a topic, of whatever type, as a bag holds it.
BagMessage toBagMessage(const std::string& topic, const topic_tools::ShapeShifter& message) {
  BagMessage result;
  result.topic = topic;
  result.type = message.getDataType();
  result.bytes.resize(message.size());
  ros::serialization::OStream stream(result.bytes.data(), message.size());
  message.write(stream);
  return result;
}

}  // namespace

SonarSource::SonarSource(ros::NodeHandle node, tf2_ros::Buffer& tf, const Odometry& odometry,
                         const NodeOptions& options, Callback callback, JumpCallback on_jump)
    : odometry_(odometry),
      callback_(std::move(callback)),
      on_jump_(std::move(on_jump)),
      mounts_(node, tf, options.base_frame_id, "Sonar"),
      ear_(
          options.sonars, [this](const std::string& frame) { return mounts_.placeOf(frame); },
          [this](const std::string& why) { complain(why); }) {
  for (const std::string& topic : namesIn(options.sonars.sonar_topics)) {
    subscribers_.push_back(subscribe<topic_tools::ShapeShifter>(
        node, topic, kQueue,
        [this, topic](const auto& message) { add(toBagMessage(topic, *message)); }));
  }
}

void SonarSource::add(const BagMessage& message) {
  auto round = ear_.hear(message);
  if (!round || round->readings.empty()) return;
  if (!leavesRoom(ros::Time(round->stamp))) return drop("its stamp is out of range");
  if (round->stamp < last_ - kTimeBack) on_jump_(ros::Time(round->stamp), round->stamp - last_);
  waiting_.push_back(std::move(*round));
  place();
  tell();
}

/// What tf can place by now; not what is older than what it could have been told with.
void SonarSource::place() {
  std::deque<SonarRound> still_waiting;
  for (SonarRound& round : waiting_) {
    std::string why;
    if (const auto T_odom_base = odometry_.at(ros::Time(round.stamp), &why)) {
      last_ = std::isfinite(last_) ? std::max(last_, round.stamp) : round.stamp;
      placed_.push_back({*T_odom_base, std::move(round)});
    } else if (waiting_.back().stamp - round.stamp < kOld) {
      still_waiting.push_back(std::move(round));
    } else {
      drop(why);
    }
  }
  waiting_ = std::move(still_waiting);
  for (; waiting_.size() > kQueue; waiting_.pop_front()) {
    drop("tf cannot place it, nor " + std::to_string(kQueue) + " that came after it");
  }
  while (!placed_.empty() && last_ - placed_.front().round.stamp > kOld) placed_.pop_front();
}

void SonarSource::tell() {
  constexpr double kPeriod = 0.095;  // s
  if (placed_.empty()) return;
  const double stamp = placed_.back().round.stamp;
  if (std::abs(stamp - told_) < kPeriod) return;
  told_ = stamp;
  const Pose2 T_odom_base = placed_.back().T_odom_base;  // which observe() takes away
  callback_(ros::Time(stamp), T_odom_base);
}

/// One that the ear could use.
void SonarSource::drop(const std::string& why) {
  ++dropped_;
  complain(why);
}

void SonarSource::complain(const std::string& why) {
  if (complaints_.isDue(why)) ROS_WARN("Sonar message, or a part of it, dropped: %s", why.c_str());
}

void SonarSource::observe(const Pose2& T_odom_base, Observations& observations) {
  place();
  std::deque<Placed> later;
  for (Placed& placed : placed_) {
    if (placed.round.stamp > observations.stamp) {
      later.push_back(std::move(placed));
      continue;
    }
    const Pose2 T_now_then = between(T_odom_base, placed.T_odom_base);
    for (SonarReading reading : placed.round.readings) {
      reading.T_base_sonar = T_now_then * reading.T_base_sonar;
      observations.sonar.push_back(reading);
    }
  }
  placed_ = std::move(later);
}

void SonarSource::forget() {
  ear_.forget();
  waiting_.clear();
  placed_.clear();
  last_ = std::numeric_limits<double>::quiet_NaN();
  told_ = 0.0;
}

std::optional<SenseHealth> SonarSource::health() const {
  if (subscribers_.empty()) return std::nullopt;
  std::string topics;
  for (const auto& subscriber : subscribers_) {
    topics += (topics.empty() ? "" : ", ") + subscriber.getTopic();
  }
  Heard heard = ear_.heard();
  heard.dropped += dropped_;
  return healthOf("sonar", heard, topics, last_);
}

}  // namespace adaptive_localization
