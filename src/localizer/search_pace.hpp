// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "map/range_error.hpp"

namespace adaptive_localization {

/// When the map is worth searching again: at once, then after 1, 3, 7 and at last every 8 scans as
/// long as nothing comes of it, and every so many metres while places are left to choose from.
class SearchPace {
 public:
  void restart() { pause_ = scans_left_ = 0; }

  /// The race begins: the next scan is searched for.
  void begin() {
    scans_left_ = 0;
    way_ = 0.0;
    error_ = RangeError::kTruncation;
    must_search_ = false;
    searches_ = 0;
  }

  /// Metres, or radians.
  void travel(double way) { way_ += way; }

  void skipScan() { --scans_left_; }

  /// Whether a scan that fits the core's place as badly as this, m, is worth a search: the pause is
  /// over, or it fits far worse than the one for which nothing better was found, as long as that
  /// one left room for it: errors end at RangeError::kTruncation.
  bool isOver(double error) const {
    return scans_left_ <= 0 || error > kFarWorse * error_without_better_;
  }

  /// Whether a scan that fits the core's place so well, m, can tell what the one for which nothing
  /// better was found could not; then no later one can that fits as well.
  bool tellsMore(double error) {
    if (error >= kFarBetter * error_without_better_) return false;
    error_without_better_ = error;
    return true;
  }

  /// The race is over: a scan fits the core's place as badly as this, m, and no other better.
  void findNothingBetter(double error) { error_without_better_ = error; }

  /// One scan later.
  bool isDue(bool has_places) { return has_places ? way_ > kWay : --scans_left_ < 0; }

  /// Places were looked for by scans that fitted none well; the last scan fits far better, with
  /// this error, and more places than those that were found may look like it. Or such a scan made
  /// another search necessary, which has no answer yet.
  bool wasBlind(double error) const {
    return must_search_ || (error_ > kWell && error < kFarBetter * error_);
  }

  /// Whether too few searches were made to know all places, none of which fitted its scan as is
  /// usual, with an error of no more than this, m: where the map is off, the true place fits worse
  /// than another, and is not found.
  bool isUnsure(double usual) const { return searches_ < kEnough && error_ > usual; }

  /// Whether the last search was for another view than this.
  bool seesElse() const { return way_ > kOtherView; }

  /// What was found so far is not enough, whatever scans come until the next search is done.
  void insist() { must_search_ = true; }

  /// A place that was known before fits the scan that was searched for, with this error, m.
  void explain(double error) { error_ = std::min(error_, error); }

  /// A scan fits none of the places better than with this error, m: the robot may have been carried
  /// to one that is not among them.
  void miss(double error) { error_ = std::max(error_, error); }

  /// Takes note of a search, and how badly the scan fits the best place that it found, m.
  void searched(bool has_come_to_something, double error) {
    pause_ = has_come_to_something ? 0 : std::min(kLongestPause, 2 * pause_ + 1);
    scans_left_ = pause_;
    way_ = 0.0;
    error_ = std::min(error_, error);
    must_search_ = false;
    ++searches_;
  }

 private:
  static constexpr double kWay = 1.0, kOtherView = 0.5;   // m or rad
  static constexpr double kWell = 0.1, kFarBetter = 0.5;  // m, of the error
  static constexpr double kFarWorse = 1.5;
  static constexpr int kLongestPause = 8, kEnough = 3;

  int pause_{0};
  int scans_left_{0};
  int searches_{0};  // in this race
  double way_{0.0};
  double error_without_better_{RangeError::kTruncation};
  double error_{RangeError::kTruncation};  // of the best place found since a scan fitted none, m
  bool must_search_{false};
};

}  // namespace adaptive_localization
