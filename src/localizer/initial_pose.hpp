// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace adaptive_localization {

/// An initial pose that was given, or none: when it has to be compared with other places
/// again. At the first scan, and then on the way, ever farther apart; and on another map once more.
class InitialPose {
 public:
  InitialPose() = default;
  explicit InitialPose(bool is_given) : is_unverified_(is_given), next_(is_given ? kFirst : 0.0) {}

  /// No scan could contradict it yet.
  bool isUnverified() const { return is_unverified_; }

  bool isCheckDue() const { return is_unverified_ || (next_ > 0.0 && left_ <= 0.0); }

  /// Metres, or radians.
  void travel(double way) {
    left_ -= way;
    way_ += way;
  }

  /// The robot is still near the initial pose: from there no scan can tell more.
  bool isFresh() const { return way_ < kFresh; }

  /// It has to be compared with other places now, and then as before, or no more.
  void checkNow() {
    left_ = 0.0;
    if (next_ == 0.0) next_ = 2.0 * kLast;
  }

  /// It was compared with all other places.
  void checked() {
    is_unverified_ = false;
    left_ = next_;
    next_ = next_ > kLast ? 0.0 : 1.5 * next_;
  }

 private:
  static constexpr double kFirst = 0.5, kLast = 10.0, kFresh = 0.3;  // m or rad

  bool is_unverified_{false};
  double left_{0.0}, way_{0.0};
  double next_{0.0};  // 0: no more
};

}  // namespace adaptive_localization
