// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace adaptive_localization {

/// The range error that there is where the robot is, by map and laser: falls at once, rises by 2 %
/// of itself at the most, so that a laser that is covered for a while does not become usual.
class UsualError {
 public:
  void observe(double error) {
    const double rise = 0.02 * (std::min(error, 2.0 * value_) - value_);
    value_ += error < value_ ? 0.2 * (error - value_) : rise;
  }

  double value() const { return value_; }

  /// The largest error that is not `times` as large as usual, nor above `most`; 0 times: `most`.
  double limit(double times, double most) const {
    constexpr double kLeast = 0.05;  // m, whatever is usual
    return times == 0.0 ? most : std::min(most, std::max(kLeast, times * value_));
  }

 private:
  double value_{0.05};  // m, a good map's
};

}  // namespace adaptive_localization
