// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Adds the reflectors in a laser scan to the landmarks that are sighted, as ones that are not
/// identified: each run of beams whose intensity is at least `reflector_intensity` and that end
/// near each other. Beams are read as toScan() reads them: within the laser's limits and the
/// mount's view, and seen from base when the first was sent, if `deskew` is on. The sighting is of
/// base; its range may be off by 5 cm, its bearing by a beam or half the run's width. Nothing is
/// done where the option is 0 or the scan has not an intensity for each beam; else the landmarks
/// are told, though there may be none.
void addReflectors(const LaserScan& scan, const LaserMount& mount, const ScanOptions& options,
                   const BaseVelocity& velocity, Observations& observations);

}  // namespace adaptive_localization
