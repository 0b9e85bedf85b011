// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Where a sensor's link sits on the robot, T_base_sensor, along the fixed joints of a URDF.
/// Throws std::invalid_argument saying what is in the way: no URDF, no such link, a joint that
/// moves.
Eigen::Isometry3d mountFromUrdf(const std::string& urdf, const std::string& base_frame,
                                const std::string& sensor_frame);

/// The angles between which a laser sees, from the URDF's <sensor> with <ray><horizontal min_angle
/// max_angle> whose parent is the laser's link; without such an element, no limits. Half a degree
/// is added on both sides for beams at the limit.
AngleLimits viewFromUrdf(const std::string& urdf, const std::string& sensor_frame);

}  // namespace adaptive_localization
