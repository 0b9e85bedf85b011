// SPDX-License-Identifier: BSD-3-Clause
#include "sonar_ear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/name_list.hpp"
#include "core/refusal.hpp"
#include "names.hpp"

namespace adaptive_localization {
namespace {

constexpr double kNoEcho = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostSonars = 256;  // of one message
constexpr int kSingle = 1000;             // sonars of their own topics are numbered from here on

/// Seen from above. Throws std::invalid_argument if it points up or down.
Pose2 fromAbove(const Eigen::Isometry3d& T_base_sonar) {
  constexpr double kSteep = 0.5;  // of the axis, upwards
  const Eigen::Vector3d axis = T_base_sonar.linear().col(0);
  if (std::abs(axis.z()) > kSteep) {
    reject("axis of a sonar", axis.z(), "one that points less than 0.5 of its length up or down");
  }
  const Eigen::Vector3d& place = T_base_sonar.translation();
  return {place.x(), place.y(), std::atan2(axis.y(), axis.x())};
}

/// Of an echo, or infinity for none.
double checkedRange(double range, double least, double most) {
  constexpr double kRounding = 0.01;  // m
  if (range >= most - kRounding && (range <= most + kRounding || std::isinf(range))) return kNoEcho;
  if (!(range >= least && range < most)) {
    std::ostringstream expected;
    expected << least << " to " << most << " m, or infinity for no echo";
    reject("range of a sonar", range, expected.str());
  }
  return range;
}

}  // namespace

bool SonarEar::listensTo(const std::string& topic) const {
  const auto wanted = namesIn(topics_.sonar_topics);
  return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& name) {
    return withoutLeadingSlash(name) == withoutLeadingSlash(topic);
  });
}

std::optional<SonarRound> SonarEar::hear(const BagMessage& message) {
  if (!listensTo(message.topic)) return std::nullopt;
  ++heard_.received;
  is_dropped_ = false;
  try {
    return roundOf(message);
  } catch (const std::exception& error) {  // of tf2 and of bytes that are no message as well
    drop(error.what());
    return std::nullopt;
  }
}

SonarRound SonarEar::roundOf(const BagMessage& message) {
  if (const auto range = message.as<sensor_msgs::Range>()) return roundOf(*range);
  if (const auto cloud = message.as<sensor_msgs::PointCloud>()) {
    checkStamp(message.topic, cloud->header.stamp.toSec());
    return roundOf(*cloud);
  }
  if (const auto array = message.as<SonarArray>()) {
    checkStamp(message.topic, array->header.stamp.toSec());
    return roundOf(*array);
  }
  throw std::invalid_argument("its type is " + message.type +
                              ", expected sensor_msgs/Range, sensor_msgs/PointCloud or "
                              "p2os_msgs/SonarArray");
}

SonarRound SonarEar::roundOf(const sensor_msgs::Range& message) {
  const std::string frame = withoutLeadingSlash(message.header.frame_id);
  if (frame.empty()) throw std::invalid_argument("its frame_id is empty");
  const double most = message.max_range, least = message.min_range;
  if (!(most > 0.0 && std::isfinite(most))) reject("max_range of a sonar", most, "one above 0");
  if (!(least >= 0.0 && least < most)) reject("min_range of a sonar", least, "0 to max_range");
  const double view = message.field_of_view;
  if (!(view >= 0.0 && view <= kPi)) reject("field_of_view of a sonar", view, "0 to pi");
  const double range = checkedRange(message.range, least, most);
  const Eigen::Isometry3d T_base_sonar = place_of_(frame);
  checkStamp(frame, message.header.stamp.toSec());
  const int next = kSingle + static_cast<int>(numbers_.size());
  SonarReading reading = readingAt(numbers_.emplace(frame, next).first->second, T_base_sonar);
  reading.range = range;
  reading.max_range = most;
  if (view > 0.0) reading.view = view;
  return {message.header.stamp.toSec(), {reading}};
}

/// Points are in the plane of the frame that the message names, which is base's with ROSARIA.
SonarRound SonarEar::roundOf(const sensor_msgs::PointCloud& message) {
  constexpr double kMostOff = 0.2;  // rad, from the axis
  const Eigen::Isometry3d T_base_cloud = place_of_(withoutLeadingSlash(message.header.frame_id));
  const auto range_of = [&](std::size_t i, const Pose2& T_base_sonar) {
    const auto& point = message.points[i];
    const Eigen::Vector3d in_base = T_base_cloud * Eigen::Vector3d(point.x, point.y, point.z);
    const Eigen::Vector2d echo = inverse(T_base_sonar) * Eigen::Vector2d(in_base.head<2>());
    const double off = std::atan2(echo.y(), echo.x());
    if (!(std::abs(off) <= kMostOff)) {
      reject("angle of a point off its sonar's axis", off, "at most 0.2 rad");
    }
    return echo.norm();
  };
  return roundOfAll(message.header.stamp.toSec(), message.points.size(), range_of);
}

SonarRound SonarEar::roundOf(const SonarArray& message) {
  const auto count = static_cast<double>(message.ranges.size());
  if (message.ranges_count != static_cast<std::int32_t>(message.ranges.size())) {
    reject("ranges_count", message.ranges_count, std::to_string(std::lround(count)));
  }
  return roundOfAll(message.header.stamp.toSec(), message.ranges.size(),
                    [&](std::size_t i, const Pose2&) { return message.ranges[i]; });
}

/// Of a message of all sonars; range_of(i, T_base_sonar) tells the range of one.
template <class RangeOf>
SonarRound SonarEar::roundOfAll(double stamp, std::size_t count, const RangeOf& range_of) {
  if (count > kMostSonars) {
    reject("number of sonars", static_cast<double>(count),
           std::to_string(kMostSonars) + " at most");
  }
  SonarRound round{stamp, {}};
  for (std::size_t i = 0; i < count; ++i) {
    try {
      const auto sonar = static_cast<int>(i);
      SonarReading reading =
          readingAt(sonar, place_of_(topics_.sonar_frame_prefix + std::to_string(i)));
      const double range = range_of(i, reading.T_base_sonar);
      reading.range = checkedRange(range, 0.0, topics_.sonar_max_range);
      if (isNew(sonar, range)) round.readings.push_back(reading);
    } catch (const std::exception& error) {  // of tf2 as well
      drop(error.what());
    }
  }
  return round;
}

SonarReading SonarEar::readingAt(int sonar, const Eigen::Isometry3d& T_base_sonar) const {
  SonarReading reading;
  reading.sonar = sonar;
  reading.T_base_sonar = fromAbove(T_base_sonar);
  reading.max_range = topics_.sonar_max_range;
  reading.view = topics_.sonar_view;
  return reading;
}

/// Whether this is no range that is told again.
bool SonarEar::isNew(int sonar, double range) {
  const auto known = ranges_.find(sonar);
  const bool is_known = known != ranges_.end() && known->second == range;
  ranges_[sonar] = range;
  return !is_known;
}

void SonarEar::checkStamp(const std::string& of, double stamp) {
  constexpr double kJump = 1.0;  // s
  const auto known = stamps_.find(of);
  const bool is_later = known == stamps_.end() || stamp > known->second;
  if (!is_later && stamp >= known->second - kJump) {
    throw std::invalid_argument("its stamp does not come after the last one");
  }
  stamps_[of] = stamp;
}

/// Once of a message, whatever else is wrong with it.
void SonarEar::drop(const std::string& why) {
  if (!std::exchange(is_dropped_, true)) ++heard_.dropped;
  complain_(why);
}

void SonarEar::forget() {
  stamps_.clear();
  ranges_.clear();
}

}  // namespace adaptive_localization
