// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include "adaptive_localization/core/scan.hpp"
#include "match/scan_matcher.hpp"
#include "ser/energy_grid.hpp"

namespace adaptive_localization {

/// The Similar Energy Region of a scan as points in the map, where base would be, one in each cell:
/// blue where a scan would have a little less energy, green as much, red a little more. Of more
/// than `most` points every second, third, ... is shown. An empty region deletes the marker.
visualization_msgs::Marker serMarker(const std_msgs::Header& header, const EnergyGrid& grid,
                                     const Scan& scan, std::size_t most);

/// A scan's hits in the map, as it was matched: green those that fit the map, magenta those that do
/// not; where the match was refused, those that fit are yellow. Without a match of this scan it
/// deletes the marker.
visualization_msgs::Marker matchMarker(const std_msgs::Header& header, const Match* match,
                                       const Scan& scan);

}  // namespace adaptive_localization
