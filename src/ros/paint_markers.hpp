// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "map/floor_plan.hpp"

namespace adaptive_localization {

/// The painted floor for rviz to show below all else: the carpet green, lines white.
visualization_msgs::MarkerArray paintMarkers(const std_msgs::Header& header, const Paint& paint);

}  // namespace adaptive_localization
