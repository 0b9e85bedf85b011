// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "adaptive_localization/map/distance_field.hpp"

namespace adaptive_localization {

/// The mean range error that there is where the robot is, by map and laser. It falls at once and
/// rises by 2 % of itself per scan at the most, so that a laser that is covered for a while does
/// not become usual.
class UsualError {
 public:
  /// What a map lets expect before anything was seen: half the depth of its walls, as far as that
  /// is more than the cell in which a beam ends. Walls that were mapped inexactly are thick.
  explicit UsualError(const DistanceField& field);

  explicit UsualError(double value = 0.05) : value_(value) {}

  void observe(double error) {
    const double rise = 0.02 * (std::min(error, 2.0 * value_) - value_);
    value_ += error < value_ ? 0.2 * (error - value_) : rise;
  }

  double value() const { return value_; }  // m

  /// The largest error that is not unusual, m.
  double limit() const { return std::max(kLeast, 2.0 * value_); }

 private:
  static constexpr double kLeast = 0.1;  // m, whatever is usual

  double value_;
};

}  // namespace adaptive_localization
