// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

#include "eval/carmen_log.hpp"

namespace adaptive_localization {

inline const char kSmallLog[] =
    "# CARMEN Logfile\n"
    "PARAM robot_frontlaser_offset 0.25 host 0\n"
    "PARAM robot_front_laser_max 50.0 host 0\n"
    "ODOM 0 0 0 0 0 0 10.0 host 0.0\n"
    "FLASER 3 1.0 2.0 81.9 0.25 0 0 0 0 0 10.1 host 0.1\n"
    "RLASER 3 1.0 2.0 3.0 0 0 0 0 0 0 10.1 host 0.1\n"
    "FLASER 3 1.5 2.5 3.5 1.25 2 0 1 2 0.5 10.2 host 0.2\n";

inline Log read(const std::string& text, const LogRequest& request = {}) {
  std::istringstream input(text);
  return readCarmenLog(input, request);
}

}  // namespace adaptive_localization
