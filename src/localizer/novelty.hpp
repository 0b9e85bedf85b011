// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// How much of a scan is new since the last one that counted, from 0 to 1.
struct News {
  double share{1.0};      // errors of its ranges are others than they were, after a step or a turn
  double sight{1.0};      // it shows other things: what a turn brings into view, or a metre does
  bool is_sudden{false};  // much of that came into view at once, from one scan to the next
  bool goes_on{false};    // each scan since some that fitted has shown what the one before did
};

/// Tells from the way since the last scan that counted how much of the next is new.
class Novelty {
 public:
  void ride(const Pose2& motion) {
    moved_ += std::hypot(motion.x, motion.y);
    turned_ += std::abs(motion.theta);
  }

  /// The next scan is the first: it counts in full.
  void restart() { moved_ = kNewSight; }

  /// A scan counted.
  void count() { moved_ = turned_ = 0.0; }

  /// Of a scan with this view, rad.
  News news(double view) const {
    const double share = std::min(1.0, (moved_ + turned_) / kNewWay);
    return {share, std::min(share, moved_ / kNewSight + turned_ / std::max(view, kNewWay))};
  }

 private:
  static constexpr double kNewWay = 0.3;    // m or rad, after which a scan is new evidence
  static constexpr double kNewSight = 1.0;  // m, after which other furniture is in view

  double moved_{0.0}, turned_{0.0};  // m, rad
};

}  // namespace adaptive_localization
