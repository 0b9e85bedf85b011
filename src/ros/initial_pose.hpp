// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include <optional>
#include <string>

#include "adaptive_localization/core/belief.hpp"
#include "odometry.hpp"

namespace adaptive_localization {

/// Takes an initial pose, as rviz sends it, to the robot's pose now: it was true at its stamp, and
/// the robot may have moved since. Where tf does not know the stamp, the pose is taken as it is.
/// Nothing, with a warning, for a frame other than the map's or numbers that make no Gaussian.
std::optional<Gaussian2> readInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message,
                                         const std::string& map_frame, const Odometry& odometry);

}  // namespace adaptive_localization
