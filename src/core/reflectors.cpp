// SPDX-License-Identifier: BSD-3-Clause
#include "core/reflectors.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kRangeDeviation = 0.05;  // m
constexpr double kStep = 0.2;             // m, of range, from one beam to the next of a reflector

bool isBright(const LaserScan& scan, std::size_t i, double least) {
  const double range = scan.ranges[i];
  return scan.intensities[i] >= least && range >= scan.range_min && range <= scan.range_max &&
         range > 0.0;
}

Sighting sightingOf(const LaserScan& scan, const LaserMount& mount, std::size_t first,
                    std::size_t last) {
  Eigen::Vector2d sum(0.0, 0.0);
  for (std::size_t i = first; i <= last; ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    sum += scan.ranges[i] * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  const auto count = static_cast<double>(last - first + 1);
  const Eigen::Vector2d point = mount.position + mount.axes * Eigen::Vector2d(sum / count);
  Sighting sighting;
  sighting.range = point.norm();
  sighting.bearing = std::atan2(point.y(), point.x());
  sighting.range_deviation = kRangeDeviation;
  const double increment = std::max(std::abs(scan.angle_increment), 1e-4);
  sighting.bearing_deviation = std::max(1.0, 0.5 * count) * increment;
  return sighting;
}

}  // namespace

void addReflectors(const LaserScan& scan, const LaserMount& mount, const ScanOptions& options,
                   Observations& observations) {
  const double least = options.reflector_intensity;
  if (!(least > 0.0) || scan.intensities.size() != scan.ranges.size()) return;
  if (!observations.landmarks) observations.landmarks.emplace();
  for (std::size_t i = 0; i < scan.ranges.size();) {
    if (!isBright(scan, i, least)) {
      ++i;
      continue;
    }
    std::size_t last = i;
    while (last + 1 < scan.ranges.size() && isBright(scan, last + 1, least) &&
           std::abs(scan.ranges[last + 1] - scan.ranges[last]) < kStep) {
      ++last;
    }
    observations.landmarks->push_back(sightingOf(scan, mount, i, last));
    i = last + 1;
  }
}

}  // namespace adaptive_localization
