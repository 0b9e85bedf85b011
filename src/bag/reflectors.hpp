// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/LaserScan.h>

#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Reflectors in a laser scan, as sightings of landmarks that are not identified: each run of beams
/// whose intensity is at least `least` and that end near each other. The sighting is of base; its
/// range may be off by 5 cm, its bearing by a beam or half the run's width. None in a scan without
/// intensities.
std::vector<Sighting> reflectorsIn(const sensor_msgs::LaserScan& message, const LaserMount& mount,
                                   double least);

}  // namespace adaptive_localization
