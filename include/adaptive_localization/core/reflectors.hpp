// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Reflectors in a laser scan, as sightings of landmarks that are not identified: each run of beams
/// whose intensity is at least `reflector_intensity` and that end near each other. The sighting is
/// of base; its range may be off by 5 cm, its bearing by a beam or half the run's width. Nothing
/// where the option is 0 or the scan has not an intensity for each beam.
std::optional<std::vector<Sighting>> reflectorsIn(const LaserScan& scan, const LaserMount& mount,
                                                  const ScanOptions& options);

}  // namespace adaptive_localization
