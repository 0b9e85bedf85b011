// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

[[noreturn]] void reject(const std::string& what, double value, const std::string& expected) {
  throw std::invalid_argument("scan: " + what + " is " + std::to_string(value) + ", expected " +
                              expected);
}

void check(const LaserScan& message) {
  if (message.ranges.empty()) reject("number of beams", 0.0, "at least 1");
  if (!std::isfinite(message.angle_min)) reject("angle_min", message.angle_min, "a finite angle");
  const bool increments = std::isfinite(message.angle_increment) && message.angle_increment != 0.0;
  if (message.ranges.size() > 1 && !increments) {
    reject("angle_increment", message.angle_increment, "a finite angle other than 0");
  }
  const auto steps = static_cast<double>(message.ranges.size() - 1);
  const double last = message.angle_min + steps * message.angle_increment;
  if (steps > 0.0 && !std::isfinite(last)) reject("angle of the last beam", last, "a finite angle");
  if (!(message.range_min >= 0.0)) reject("range_min", message.range_min, "0 m or more");
  if (!(message.range_max > message.range_min)) {
    reject("range_max", message.range_max, "more than range_min");
  }
}

/// A mount that mirrors the plane (upside down) makes the last beam the rightmost.
void setView(const LaserScan& message, const LaserMount& mount, Scan& scan) {
  const auto steps = static_cast<double>(message.ranges.size() - 1);
  const double swept = steps > 0.0 ? steps * message.angle_increment : 0.0;
  const bool mirrored = mount.axes(0, 0) * mount.axes(1, 1) < mount.axes(0, 1) * mount.axes(1, 0);
  const bool last_is_rightmost = (swept < 0.0) != mirrored;
  const double angle = message.angle_min + (last_is_rightmost ? swept : 0.0);
  const Eigen::Vector2d direction = mount.axes * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  scan.view_start = std::atan2(direction.y(), direction.x());
  scan.view_width = std::min(std::abs(swept), 2.0 * kPi);
}

}  // namespace

LaserMount LaserMount::level(const Pose2& T_base_sensor) {
  const double c = std::cos(T_base_sensor.theta);
  const double s = std::sin(T_base_sensor.theta);
  LaserMount mount;
  mount.position = {T_base_sensor.x, T_base_sensor.y};
  mount.axes << c, -s, s, c;
  return mount;
}

LaserMount LaserMount::upsideDown(const Pose2& T_base_sensor) {
  LaserMount mount = level(T_base_sensor);
  mount.axes.col(1) = -mount.axes.col(1);
  return mount;
}

double durationOf(const LaserScan& message) {
  constexpr double kLongest = 2.0;  // s
  if (message.ranges.size() < 2) return 0.0;
  const double duration = message.time_increment * static_cast<double>(message.ranges.size() - 1);
  return duration > 0.0 && duration < kLongest ? duration : 0.0;
}

Scan toScan(const LaserScan& message, const LaserMount& mount, const ScanOptions& options,
            const BaseVelocity& velocity) {
  check(message);
  const double min_range = std::max(message.range_min, options.laser_min_range);
  // a driver may say that its laser has no limit; the models need a number
  const double limit = std::min<double>(message.range_max, std::numeric_limits<float>::max());
  const double max_range =
      options.laser_max_range > 0.0 ? std::min(limit, options.laser_max_range) : limit;
  const auto beams = static_cast<Eigen::Index>(message.ranges.size());
  const bool moves = velocity.x != 0.0 || velocity.y != 0.0 || velocity.turn != 0.0;
  const double between_beams =
      options.deskew && moves && durationOf(message) > 0.0 ? message.time_increment : 0.0;
  const Eigen::Index used = std::min<Eigen::Index>(beams, options.laser_max_beams);

  Scan scan;
  scan.position = mount.position;
  scan.max_range = max_range;
  setView(message, mount, scan);
  scan.x.resize(used);
  scan.y.resize(used);
  scan.range.resize(used);
  scan.bearing.resize(used);
  scan.no_return_bearing.resize(used);
  Eigen::Index hits = 0;
  Eigen::Index no_returns = 0;
  for (Eigen::Index k = 0; k < used; ++k) {
    // evenly spread from the first beam to the last, rounded to the nearest
    const Eigen::Index i = used == beams ? k : (k * (beams - 1) + (used - 1) / 2) / (used - 1);
    const double range = message.ranges[static_cast<std::size_t>(i)];
    const double angle = i == 0
                             ? message.angle_min
                             : message.angle_min + static_cast<double>(i) * message.angle_increment;
    const bool in_view = angle >= mount.view.low && angle <= mount.view.high;
    if (std::isnan(range) || range <= 0.0 || range < min_range || !in_view) {
      ++scan.invalid;
      continue;
    }
    const double t = static_cast<double>(i) * between_beams;
    const Pose2 T_first_now{velocity.x * t, velocity.y * t, velocity.turn * t};
    const Eigen::Vector2d direction =
        mount.axes * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const double bearing_now = std::atan2(direction.y(), direction.x());
    const auto bearing = static_cast<float>(
        between_beams > 0.0 ? wrapAngle(bearing_now + T_first_now.theta) : bearing_now);
    if (range >= max_range) {
      scan.no_return_bearing[no_returns++] = bearing;
      continue;
    }
    Eigen::Vector2d point = mount.position + range * direction;
    if (between_beams > 0.0) point = T_first_now * point;
    scan.x[hits] = static_cast<float>(point.x());
    scan.y[hits] = static_cast<float>(point.y());
    scan.range[hits] = static_cast<float>(range * direction.norm());
    scan.bearing[hits] = bearing;
    ++hits;
  }
  scan.x.conservativeResize(hits);
  scan.y.conservativeResize(hits);
  scan.range.conservativeResize(hits);
  scan.bearing.conservativeResize(hits);
  scan.no_return_bearing.conservativeResize(no_returns);
  return scan;
}

}  // namespace adaptive_localization
