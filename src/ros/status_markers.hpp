// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "adaptive_localization/localizer/localizer.hpp"
#include "match/scan_matcher.hpp"

namespace adaptive_localization {

/// Status and confidence as a text beside the robot, with the reason if the last scan was not
/// matched, and beside each other place where it may be the share of the belief that is there.
/// Without a match there is none to tell of.
visualization_msgs::MarkerArray statusMarkers(const std_msgs::Header& header,
                                              const Localization& answer, const Match* match);

}  // namespace adaptive_localization
