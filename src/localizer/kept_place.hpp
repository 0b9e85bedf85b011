// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "map/range_error.hpp"
#include "ser/place_refiner.hpp"

namespace adaptive_localization {

/// So much of a view one thing that the map does not have may hide, rad: all that a camera sees.
constexpr double kMostOfView = kPi / 2.0;

/// What scans of such a view may say at most against a place that was believed in, and those of any
/// laser where each shows what the one before did; log odds by what comes into sight in a metre.
constexpr double kMostPerMetre = 3.0;

/// Beams that do not fit rather end before what the map has than go on where it has a wall.
bool isHidden(const RangeError::Fit& fit);

/// What a scan may say at most, in log odds, against a place where the robot was told or known to
/// be. Where most of the scan does not fit there it has no bound, unless one thing may fill the
/// whole view. Where most of it fits, by ranges or by where hits are, something there has rather
/// changed than is it another place. Least of all is said by beams that end before what the map
/// has, if hardly any go on where it has a wall: people, things that were brought, and walls that
/// are missing on the map do that, to half of a scan or to 90 degrees, which may be all that a
/// camera sees. So little do beams that go on say if nearly all that do not end before the map's
/// walls, or all but one where they are few, end at some, as near as is usual on this map: then
/// something was taken away. From another place, beams go on through walls here and there.
double mostAgainst(const PlaceRefiner& refiner, const Pose2& T_map_base, bool is_word,
                   double usual_error);

}  // namespace adaptive_localization
