// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/core/scan.hpp"

#include <cmath>

namespace adaptive_localization {

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

}  // namespace adaptive_localization
