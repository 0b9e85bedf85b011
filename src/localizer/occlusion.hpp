// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/match/match.hpp"
#include "map/range_error.hpp"

namespace adaptive_localization {

/// No beam, but for stray ones, returns: there is nothing within the laser's range.
bool seesNothing(const Scan& scan);

/// A hand before the laser, or somebody who stands there, looks like a corner of the map somewhere:
/// a scan that sees hardly anything beyond arm's length is no evidence, nor are stray hits.
bool isCovered(const Scan& scan);

/// Nearly all beams of a scan, taken about a pose, are too short: it tells of what stands before
/// the laser and not of where it is.
bool areTooShort(const Scan& scan, const Pose2& T_map_base, const RangeError& range_error);

/// A scan about a pose without the hits that lie before the map's walls and on none: people, or
/// furniture that was moved, draw a pose to where they would be walls (the distance filter; Fox,
/// Burgard and Thrun 1999). All of it where fewer than half of the hits are on walls, as then the
/// pose may be wrong and each hit tells.
Scan withoutObstacles(const Scan& scan, const Pose2& T_map_base, const DistanceField& field,
                      const RangeError& range_error);

/// A match of what was left of a scan, as one of all of it: hits that were left out do not fit. One
/// that does not tell which hits fit stays as it is.
Match ofWholeScan(Match match, const Scan& left, const Scan& all);

}  // namespace adaptive_localization
