// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// How far a motion brought the robot to see something else: metres and radians together.
inline double wayOf(const Pose2& motion) {
  return std::hypot(motion.x, motion.y) + std::abs(motion.theta);
}

/// When the map is worth searching again: at once, then after 1, 3, 7 and at last every 8 scans as
/// long as nothing comes of it, and every so many metres while places are left to choose from.
class SearchPace {
 public:
  void restart() { pause_ = scans_left_ = 0; }

  /// The race begins: the next scan is searched for.
  void begin() {
    scans_left_ = 0;
    way_ = 0.0;
  }

  /// Metres, or radians.
  void travel(double way) { way_ += way; }

  void skipScan() { --scans_left_; }
  bool isOver() const { return scans_left_ <= 0; }

  /// One scan later.
  bool isDue(bool has_places) { return has_places ? way_ > kWay : --scans_left_ < 0; }

  /// Takes note of a search.
  void searched(bool has_come_to_something) {
    pause_ = has_come_to_something ? 0 : std::min(kLongestPause, 2 * pause_ + 1);
    scans_left_ = pause_;
    way_ = 0.0;
  }

 private:
  static constexpr double kWay = 1.0;
  static constexpr int kLongestPause = 8;

  int pause_{0};
  int scans_left_{0};
  double way_{0.0};
};

}  // namespace adaptive_localization
