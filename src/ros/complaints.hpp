// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <map>
#include <string>

namespace adaptive_localization {

/// Says when a reason for dropping messages is worth a line in the log: another reason at once, the
/// same, whatever its figures, now and then.
class Complaints {
 public:
  bool isDue(const std::string& why) {
    constexpr std::size_t kKept = 100;
    const ros::WallDuration kAgain(5.0);
    if (said_.size() > kKept) said_.clear();
    ros::WallTime& said = said_[why.substr(0, why.find_first_of("0123456789"))];
    const auto now = ros::WallTime::now();
    if (now - said < kAgain) return false;
    said = now;
    return true;
  }

 private:
  std::map<std::string, ros::WallTime> said_;
};

}  // namespace adaptive_localization
