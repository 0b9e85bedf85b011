// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "map/range_error.hpp"

namespace adaptive_localization {

/// The mean range error that there is where the robot is, by map and laser. It falls within
/// some 20 scans and rises by 2 % of itself per scan at the most: neither does a corner that is
/// mapped well speak for the whole map, nor does a laser that is occluded for a while become usual.
class UsualError {
 public:
  /// Starts from what the map lets expect, m: MapQuality::rangeError().
  explicit UsualError(double value = 0.05)
      : value_(value), known_(value), most_(std::clamp(3.0 * value, kMost, kMostOfAll)) {}

  /// Where the robot is known to be.
  void observe(double error) {
    follow(error);
    known_ = value_;
  }

  /// At a place that may be another one: there it rises to no more than it was where the place was
  /// known, or than the map lets expect. Else scans of a wrong place would soon be usual.
  void observeUnknown(double error) { follow(std::min(error, std::max(value_, known_))); }

  double value() const { return value_; }  // m

  /// The largest error that is not unusual, m.
  double limit() const { return std::min(most_, std::max(kLeast, 2.0 * value_)); }

 private:
  static constexpr double kLeast = 0.1, kMost = 0.3;  // m, whatever is usual
  static constexpr double kMostOfAll = 0.9 * RangeError::kTruncation;

  void follow(double error) {
    value_ +=
        error < value_ ? 0.05 * (error - value_) : 0.02 * (std::min(error, 2.0 * value_) - value_);
  }

  double value_;
  double known_;  // m, where the place was known last
  double most_;   // m, three times what the map lets expect, within [kMost, kMostOfAll]
};

}  // namespace adaptive_localization
