// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include "adaptive_localization/match/scan_matcher.hpp"

namespace adaptive_localization {

/// A scan's hits in the map, as it was matched: green those that fit the map, magenta those that do
/// not; where the match was refused, those that fit are yellow. Without a match of this scan it
/// deletes the marker.
visualization_msgs::Marker matchMarker(const std_msgs::Header& header, const Match* match,
                                       const Scan& scan);

}  // namespace adaptive_localization
