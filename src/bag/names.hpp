// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace adaptive_localization {

/// Frames and topics had a leading slash in ROS's early days, and some drivers still send one.
inline std::string withoutLeadingSlash(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

}  // namespace adaptive_localization
