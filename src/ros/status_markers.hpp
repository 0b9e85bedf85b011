// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "adaptive_localization/localizer.hpp"

namespace adaptive_localization {

/// Status and confidence as a text beside the robot, and beside each other place where it may be
/// the share of the belief that is there.
visualization_msgs::MarkerArray statusMarkers(const std_msgs::Header& header,
                                              const Localization& answer);

}  // namespace adaptive_localization
