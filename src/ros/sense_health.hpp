// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <cmath>
#include <string>

#include "../bag/heading_ear.hpp"

namespace adaptive_localization {

/// How a sense beside the laser is heard, for a reader.
struct SenseHealth {
  std::string name;
  Heard heard;
  std::string missing;  // "nothing heard on /imu", "silent for 3 s"; empty while it is heard
};

/// The same with what becomes of it.
struct SenseStatus {
  SenseHealth health;
  std::string state;  // "used", "disturbed", "silent for 3 s"
  bool is_fine{true};
};

/// Of a sense on some topics, whose last message that could be used has this stamp in s; not a
/// number if none could.
inline SenseHealth healthOf(const std::string& name, const Heard& heard, const std::string& topics,
                            double last) {
  constexpr double kSilence = 1.0;  // s
  SenseHealth health{name, heard, ""};
  if (heard.received == 0) {
    health.missing = "nothing heard on " + topics;
  } else if (!std::isfinite(last)) {
    health.missing = "no message can be used";
  } else if (const double silent = ros::Time::now().toSec() - last; silent > kSilence) {
    health.missing = "silent for " + std::to_string(std::lround(silent)) + " s";
  }
  return health;
}

}  // namespace adaptive_localization
