// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/log.hpp"

namespace adaptive_localization {

/// Reads a rosbag (*.bag) or a CARMEN log (anything else; *.gz and *.bz2 are unpacked).
/// Throws std::invalid_argument naming the file and what is wrong with it, also when no scan is
/// left.
Log readLog(const LogRequest& request);

}  // namespace adaptive_localization
