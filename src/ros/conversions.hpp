// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <geometry_msgs/Transform.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/LaserScan.h>

#include <Eigen/Geometry>
#include <string>

#include "../bag/names.hpp"
#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// Throws std::runtime_error naming all of these unless a frame is within so many metres of its
/// parent.
void checkPlace(const std::string& frame, const std::string& parent, double x, double y,
                double most);

LaserScan toLaserScan(const sensor_msgs::LaserScan& message);
/// Without header and scan_time.
sensor_msgs::LaserScan toMessage(const LaserScan& scan);

/// Throws std::invalid_argument for a size, resolution or origin that makes no map.
/// The origin is the corner of cell (0, 0), as the message says, or its centre, as some mappers
/// think.
OccupancyGrid toGrid(const nav_msgs::OccupancyGrid& message, bool origin_is_cell_center = false);
nav_msgs::OccupancyGrid toMessage(const OccupancyGrid& grid);

/// Not checked against any map. A size that is no int becomes -1.
MapPatch toPatch(const map_msgs::OccupancyGridUpdate& message);

/// x, y and yaw. A quaternion of zeros, as an unfilled message has, is no rotation.
Pose2 toPose2(const geometry_msgs::Pose& message);
Pose2 toPose2(const geometry_msgs::Transform& message);
geometry_msgs::Pose toPoseMessage(const Pose2& pose);
geometry_msgs::Transform toTransformMessage(const Pose2& pose);
geometry_msgs::Transform toTransformMessage(const Eigen::Isometry3d& transform);

/// How a laser sits, seen from above, from the transform of its frame to base.
LaserMount toMount(const geometry_msgs::Transform& message);
Eigen::Isometry3d toIsometry(const geometry_msgs::Transform& message);

/// From the x, y and yaw blocks of a 6 x 6 covariance over (x, y, z, roll, pitch, yaw), as amcl
/// reads it: entries 0, 1, 6, 7 and 35.
Gaussian2 toGaussian(const geometry_msgs::PoseWithCovariance& message);
geometry_msgs::PoseWithCovariance toMessage(const Pose2& pose, const Eigen::Matrix3d& covariance);

geometry_msgs::PoseArray toMessage(const Particles& particles);

}  // namespace adaptive_localization
