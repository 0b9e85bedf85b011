// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "map/landmark_map.hpp"

namespace adaptive_localization {

/// Known landmarks as posts, and the newest sightings of landmarks as lines from the robot to where
/// they are by its pose: those that end at a post fit.
visualization_msgs::MarkerArray landmarkMarkers(const std_msgs::Header& header,
                                                const LandmarkMap& known, const Pose2& T_map_base,
                                                const std::vector<Sighting>& sightings);

}  // namespace adaptive_localization
