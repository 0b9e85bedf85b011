// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// The true robot, a disc with an arrow, and the people, for rviz to show beside the estimate.
visualization_msgs::MarkerArray truthMarkers(const std_msgs::Header& header,
                                             const Pose2& T_map_base,
                                             const std::vector<Eigen::Vector2d>& people);

}  // namespace adaptive_localization
