// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Log odds of the core's place against any other, before a scan is looked at. An initial pose
/// starts with what somebody's word is worth; tracking earns more, metre by metre; a scan that sees
/// nothing takes some away, so does the way that a lost robot drives while its scans look as usual,
/// and odometry that jumps takes all.
class TrackingOdds {
 public:
  static constexpr double kMargin = 6.0;  // below the likeliest place, at which one is ruled out

  TrackingOdds() = default;
  explicit TrackingOdds(bool is_given)
      : value_(is_given ? kInitial : kFound), word_(is_given ? kInitial : 0.0) {}

  double value() const { return value_; }

  /// How much of it is only somebody's word: no scan has told the place from all others yet.
  double word() const { return std::min(word_, value_); }

  /// There is so much that what stands about the robot may have changed, little by little, rather
  /// than the robot's place: more than being carried leaves.
  bool isKept() const { return value_ > kMost - kCarried; }

  void earn(const Pose2& motion) {
    const double earned = value_ + kPerMetre * std::hypot(motion.x, motion.y);
    value_ = std::max(value_, std::min(kMost, earned));
  }

  /// Twice as much where scans hardly fit.
  void loseWay(const Pose2& motion, bool hardly_fits = false) {
    lose((hardly_fits ? 2.0 : 1.0) * kPerMetreLost * std::hypot(motion.x, motion.y));
  }

  /// No more is known of the place than a search for it would tell.
  bool areSpent() const { return value_ <= kFound; }

  /// Less is known of the place than a search for it would tell.
  bool areLost() const { return value_ < kFound; }

  /// Whether they rule out that the robot was carried to one of so many places that look alike, by
  /// a scan that suddenly fitted far worse.
  bool ruleOut(int alike) const {
    return alike == 0 || value_ - kSudden > kMargin + std::log(alike);
  }

  void seeNothing() { value_ *= kLeft; }

  /// The same by each tenth of a metre or radian of such scans, or by ten scans from one place.
  void seeNothing(const Pose2& motion) {
    constexpr double kStep = 0.1, kLeast = 0.1;  // m or rad; of a step
    value_ *= std::pow(kLeft, std::clamp(wayOf(motion) / kStep, kLeast, 1.0));
  }

  /// Down to what a search for the place would tell.
  void lose(double log_odds) { value_ = std::max(std::min(value_, kFound), value_ - log_odds); }

  /// What the laser sees when it is carried away it hardly ever sees otherwise.
  void beCarried() {
    lose(kCarried);
    word_ = 0.0;
  }

  /// Nobody drives so far from one update to the next.
  void checkJump(const Pose2& motion) {
    constexpr double kJump = 3.0;  // m
    if (std::hypot(motion.x, motion.y) > kJump) value_ = 0.0;
  }

  /// The scans left no other place.
  void find() {
    value_ = std::max(value_, kFound);
    word_ = 0.0;
  }

 private:
  static constexpr double kInitial = 9.0, kFound = 3.0, kMost = 18.0;
  static constexpr double kLeft = 0.9;      // by a scan that sees nothing
  static constexpr double kCarried = 10.0;  // two scans of 31 000 did otherwise
  static constexpr double kSudden = 9.0;    // of a tracked robot, five scans of 6500 did otherwise
  static constexpr double kPerMetre = 3.0, kPerMetreLost = 1.0;

  double value_{kFound};
  double word_{0.0};
};

}  // namespace adaptive_localization
