// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud.h>

#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "adaptive_localization/core/observations.hpp"

namespace adaptive_localization {

/// Landmarks as sensor_msgs/PointCloud has them: points in the sensor's frame, with channels `id`
/// (-1: not identified; without the channel none is), `range_std` in m and `bearing_std` in rad.
/// The sightings are of base, seen from above. A point that makes no sense is left out, and
/// `refuse` is told why: numbers that are not finite, a standard deviation that is not above 0, an
/// id that is no whole number from -1 on. Throws std::invalid_argument where a channel is missing
/// or has not a value for each point.
std::vector<Sighting> toSightings(const sensor_msgs::PointCloud& message,
                                  const Eigen::Isometry3d& T_base_sensor,
                                  const std::function<void(const std::string& why)>& refuse);

/// Such a message with its channels and no points yet.
sensor_msgs::PointCloud noSightings();

/// One more landmark in it: where it is in the sensor's frame, m, and the standard deviations of
/// its range, m, and bearing, rad.
void addSighting(sensor_msgs::PointCloud& message, const Eigen::Vector3d& place, int id,
                 double range_deviation, double bearing_deviation);

}  // namespace adaptive_localization
