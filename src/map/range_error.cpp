// SPDX-License-Identifier: BSD-3-Clause
#include "map/range_error.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {

/// By how much a beam is too short, m; negative: too long.
double RangeError::missing(const Pose2& ray, double range, double max_range) const {
  constexpr double kRobot = 0.4;  // m, from the laser: no wall can be there, though the map has one
  const auto from = [&](const Pose2& start, double way) {
    const double z = range - way;
    const RayCaster::Wall wall = ray_caster_.wall(start, max_range - way, wall_depth_, z);
    return z < wall.near ? wall.near - z : std::min(0.0, wall.far - z);
  };
  const double plain = from(ray, 0.0);
  if (wall_depth_ == 0.0 || plain > -truncation_ || range < kRobot) return plain;
  if (range + plain > kRobot) return plain;  // the wall is farther off
  const double through = from(ray * Pose2{kRobot, 0.0, 0.0}, kRobot);
  return std::abs(through) < std::abs(plain) ? through : plain;
}

double RangeError::missing(const Pose2& T_map_base, const Scan& scan, Eigen::Index hit) const {
  const Eigen::Vector2d sensor = T_map_base * scan.position;
  const Pose2 ray{sensor.x(), sensor.y(), wrapAngle(T_map_base.theta + scan.bearing[hit])};
  return missing(ray, scan.range[hit], scan.max_range);
}

RangeError::Fit RangeError::at(const Pose2& T_map_base, const Scan& scan, double max_range) const {
  constexpr Eigen::Index kBeams = 90;  // are enough for a mean
  constexpr double kOff = 0.25;        // m
  const Eigen::Vector2d sensor = T_map_base * scan.position;
  double sum = 0.0;
  int count = 0, too_short = 0, too_long = 0;
  const auto add = [&](double bearing, double range) {
    const Pose2 ray{sensor.x(), sensor.y(), wrapAngle(T_map_base.theta + bearing)};
    const double off = missing(ray, std::min(range, max_range), max_range);
    sum += std::min(std::abs(off), truncation_);
    too_short += off > kOff ? 1 : 0;
    too_long += off < -kOff ? 1 : 0;
    ++count;
  };
  const Eigen::Index beams = scan.range.size() + scan.no_return_bearing.size();
  const Eigen::Index stride = std::max<Eigen::Index>(1, beams / kBeams);
  for (Eigen::Index i = 0; i < scan.range.size(); i += stride) {
    add(scan.bearing[i], scan.range[i]);
  }
  for (Eigen::Index i = 0; i < scan.no_return_bearing.size(); i += stride) {
    add(scan.no_return_bearing[i], max_range);
  }
  if (count == 0) return {truncation_};
  return {sum / count, static_cast<double>(too_short) / count,
          static_cast<double>(too_short + too_long) / count};
}

}  // namespace adaptive_localization
