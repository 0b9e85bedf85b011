// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>

#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Finds scans whose sweep cannot have taken as long as they say: no laser needs longer for one
/// than until the next begins. Some drivers send any number as time_increment, and scans would be
/// bent by it.
class SweepWatch {
 public:
  /// Whether it can be, by the longest but one of the last few times between scans in this frame:
  /// one may be a pause. The first scan is believed.
  bool isPossible(const std::string& frame, const LaserScan& scan);

 private:
  static constexpr std::size_t kPeriods = 5;

  struct Seen {
    double stamp{0.0};
    std::size_t count{0};                   // scans
    std::array<double, kPeriods> period{};  // s, between the last ones; 0: not known yet
  };
  std::map<std::string, Seen> seen_;
};

}  // namespace adaptive_localization
