// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "eval/log.hpp"

namespace adaptive_localization {

/// Reads a CARMEN log (plain, .gz or .bz2): the front laser's FLASER or ROBOTLASER1 lines with the
/// odometry in them, and the PARAM lines that say where the laser sits (robot_frontlaser_offset)
/// and how far it sees (robot_front_laser_max). A FLASER scan spans 180 degrees.
///
/// A broken line is skipped, counted and named by number in the log's warnings. Scans
/// stamped later than one after them are spread evenly before it.
/// Throws std::invalid_argument naming the file when it cannot be unpacked.
Log readCarmenLog(const LogRequest& request);
Log readCarmenLog(std::istream& input, const LogRequest& request);

}  // namespace adaptive_localization
