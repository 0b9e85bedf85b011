// SPDX-License-Identifier: BSD-3-Clause
#include "reflectors.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kRangeDeviation = 0.05;  // m
constexpr double kStep = 0.2;             // m, of range, from one beam to the next of a reflector

bool isBright(const sensor_msgs::LaserScan& message, std::size_t i, double least) {
  const double range = message.ranges[i];
  return message.intensities[i] >= least && range >= message.range_min &&
         range <= message.range_max && range > 0.0;
}

Sighting sightingOf(const sensor_msgs::LaserScan& message, const LaserMount& mount,
                    std::size_t first, std::size_t last) {
  Eigen::Vector2d sum(0.0, 0.0);
  for (std::size_t i = first; i <= last; ++i) {
    const double angle = message.angle_min + static_cast<double>(i) * message.angle_increment;
    sum += message.ranges[i] * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  const auto count = static_cast<double>(last - first + 1);
  const Eigen::Vector2d point = mount.position + mount.axes * Eigen::Vector2d(sum / count);
  Sighting sighting;
  sighting.range = point.norm();
  sighting.bearing = std::atan2(point.y(), point.x());
  sighting.range_deviation = kRangeDeviation;
  const double increment = std::max(std::abs(double{message.angle_increment}), 1e-4);
  sighting.bearing_deviation = std::max(1.0, 0.5 * count) * increment;
  return sighting;
}

}  // namespace

std::vector<Sighting> reflectorsIn(const sensor_msgs::LaserScan& message, const LaserMount& mount,
                                   double least) {
  std::vector<Sighting> sightings;
  if (message.intensities.size() != message.ranges.size()) return sightings;
  for (std::size_t i = 0; i < message.ranges.size();) {
    if (!isBright(message, i, least)) {
      ++i;
      continue;
    }
    std::size_t last = i;
    while (last + 1 < message.ranges.size() && isBright(message, last + 1, least) &&
           std::abs(message.ranges[last + 1] - message.ranges[last]) < kStep) {
      ++last;
    }
    sightings.push_back(sightingOf(message, mount, i, last));
    i = last + 1;
  }
  return sightings;
}

}  // namespace adaptive_localization
