// SPDX-License-Identifier: BSD-3-Clause
#include "sighting_messages.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "core/refusal.hpp"

namespace adaptive_localization {
namespace {

constexpr double kMostReach = 1e4;  // m

/// Null where the message has no such channel.
const std::vector<float>* channel(const sensor_msgs::PointCloud& message, const std::string& name) {
  const auto found = std::find_if(message.channels.begin(), message.channels.end(),
                                  [&](const auto& one) { return one.name == name; });
  if (found == message.channels.end()) return nullptr;
  if (found->values.size() == message.points.size()) return &found->values;
  throw std::invalid_argument("channel '" + name + "': got " +
                              std::to_string(found->values.size()) + " values, expected " +
                              std::to_string(message.points.size()) + ", one for each point");
}

const std::vector<float>& neededChannel(const sensor_msgs::PointCloud& message,
                                        const std::string& name) {
  if (const auto* values = channel(message, name)) return *values;
  throw std::invalid_argument("it has no channel '" + name + "'");
}

void checkDeviation(const std::string& what, double value) {
  if (!(value > 0.0 && std::isfinite(value))) reject(what + " of a landmark", value, "one above 0");
}

int toId(double value) {
  if (!(value >= -1.0 && value < 1e7 && value == std::floor(value))) {
    reject("id of a landmark", value, "a whole number from -1 on");
  }
  return static_cast<int>(value);
}

/// Range and bearing of base of a point that a sensor elsewhere on the robot sees in polar
/// coordinates of its own.
Sighting sightingOf(const Eigen::Vector2d& in_sensor, const Eigen::Isometry2d& T_base_sensor,
                    double range_deviation, double bearing_deviation) {
  constexpr double kLeast = 1e-3;  // m, where there is no bearing
  const double range = in_sensor.norm();
  const Eigen::Vector2d along = range > kLeast ? Eigen::Vector2d(in_sensor / range)
                                               : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  Eigen::Matrix2d axes;
  axes << along.x(), -along.y(), along.y(), along.x();
  axes = T_base_sensor.linear() * axes;
  const Eigen::Vector2d deviations(range_deviation, std::max(range, kLeast) * bearing_deviation);
  const Eigen::Matrix2d covariance = axes * deviations.cwiseAbs2().asDiagonal() * axes.transpose();
  const Eigen::Vector2d in_base = T_base_sensor * in_sensor;
  Sighting sighting;
  sighting.range = std::max(in_base.norm(), kLeast);
  sighting.bearing = std::atan2(in_base.y(), in_base.x());
  const Eigen::Vector2d out(std::cos(sighting.bearing), std::sin(sighting.bearing));
  const Eigen::Vector2d aside(-out.y(), out.x());
  sighting.range_deviation = std::sqrt(out.dot(covariance * out));
  sighting.bearing_deviation = std::sqrt(aside.dot(covariance * aside)) / sighting.range;
  return sighting;
}

Eigen::Isometry2d fromAbove(const Eigen::Isometry3d& T_base_sensor) {
  const Eigen::Vector3d x = T_base_sensor.linear().col(0);
  Eigen::Isometry2d flat = Eigen::Isometry2d::Identity();
  flat.linear() = Eigen::Rotation2Dd(std::atan2(x.y(), x.x())).toRotationMatrix();
  flat.translation() = T_base_sensor.translation().head<2>();
  return flat;
}

}  // namespace

std::vector<Sighting> toSightings(const sensor_msgs::PointCloud& message,
                                  const Eigen::Isometry3d& T_base_sensor,
                                  const std::function<void(const std::string& why)>& refuse) {
  const auto* ids = channel(message, "id");
  const auto& range_std = neededChannel(message, "range_std");
  const auto& bearing_std = neededChannel(message, "bearing_std");
  const Eigen::Isometry2d flat = fromAbove(T_base_sensor);
  std::vector<Sighting> sightings;
  for (std::size_t i = 0; i < message.points.size(); ++i) {
    const auto& point = message.points[i];
    try {
      const Eigen::Vector3d in_base = T_base_sensor * Eigen::Vector3d(point.x, point.y, point.z);
      if (!(in_base.norm() < kMostReach))
        reject("place of a landmark", in_base.norm(), "at most 10 km away");
      checkDeviation("range_std", range_std[i]);
      checkDeviation("bearing_std", bearing_std[i]);
      const Eigen::Vector2d in_sensor = flat.inverse() * Eigen::Vector2d(in_base.head<2>());
      Sighting sighting = sightingOf(in_sensor, flat, range_std[i], bearing_std[i]);
      sighting.id = ids ? toId((*ids)[i]) : -1;
      sightings.push_back(sighting);
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
  }
  return sightings;
}

sensor_msgs::PointCloud noSightings() {
  const char* const names[] = {"id", "range_std", "bearing_std"};
  sensor_msgs::PointCloud message;
  for (const char* name : names) {
    message.channels.emplace_back();
    message.channels.back().name = name;
  }
  return message;
}

void addSighting(sensor_msgs::PointCloud& message, const Eigen::Vector3d& place, int id,
                 double range_deviation, double bearing_deviation) {
  geometry_msgs::Point32 point;
  point.x = static_cast<float>(place.x());
  point.y = static_cast<float>(place.y());
  point.z = static_cast<float>(place.z());
  message.points.push_back(point);
  message.channels[0].values.push_back(static_cast<float>(id));
  message.channels[1].values.push_back(static_cast<float>(range_deviation));
  message.channels[2].values.push_back(static_cast<float>(bearing_deviation));
}

}  // namespace adaptive_localization
