// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/Range.h>

#include "sim/simulation.hpp"

namespace adaptive_localization {

// What simulated sensors read, as their drivers send it; without headers.

nav_msgs::Odometry toMessage(const Pose2& pose, const Velocity& velocity);
sensor_msgs::Imu toMessage(const ImuReading& reading);
/// Sighted landmarks, with their ids and standard deviations in m and rad.
sensor_msgs::PointCloud toMessage(const Picture& picture);
sensor_msgs::Range toMessage(const SonarReading& reading);

}  // namespace adaptive_localization
