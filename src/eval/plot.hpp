// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "eval/metrics.hpp"

namespace adaptive_localization {

/// Draws the map around the run, the reference (blue) and the estimate (red) with legend, scale bar
/// and the error in numbers. Throws std::runtime_error naming the file that could not be written.
void savePlot(const OccupancyGrid& map, const RunRecord& run, const Metrics& metrics,
              const std::string& file);

}  // namespace adaptive_localization
