// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/map/distance_field.hpp"

namespace adaptive_localization {

/// Whether most of a scan's beams saw nothing, as in a hall that is wider than the laser's range.
bool isMostlyOpen(const Scan& scan);

/// For each particle, how many of a scan's no-returns go through a wall that is well within the
/// laser's range: nearer than 0.9 max_range - 0.2 m, and not where the robot stands. 24 of them are
/// looked at, evenly spread, or fewer for many particles, and each counts for those beside it. One
/// alone does not: what one beam goes through is speckle sooner than a wall.
Eigen::ArrayXd missedWalls(const Scan& scan, const Particles& particles,
                           const DistanceField& field);

}  // namespace adaptive_localization
