// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <limits>

namespace adaptive_localization {

/// Whether an hour can be added to a stamp. roscpp and tf2 add to stamps and throw where
/// ros::Time's 32 bits of seconds end.
inline bool leavesRoom(const ros::Time& stamp) {
  constexpr std::uint32_t kHour = 3600;
  return stamp.sec < std::numeric_limits<std::uint32_t>::max() - kHour;
}

}  // namespace adaptive_localization
