// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Reflectors in a laser scan, as sightings of landmarks that are not identified: each run of beams
/// whose intensity is at least `least` and that end near each other. The sighting is of base; its
/// range may be off by 5 cm, its bearing by a beam or half the run's width. None where
/// there is not an intensity for each beam.
std::vector<Sighting> reflectorsIn(const LaserScan& scan, const std::vector<float>& intensities,
                                   const LaserMount& mount, double least);

}  // namespace adaptive_localization
