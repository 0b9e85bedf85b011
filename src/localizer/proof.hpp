// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Whether a place is known that scans alone told, and nobody. Where the map's walls are rough,
/// scans fit many a place, and the true one may not be among those found: there the scans must go
/// on fitting for some way, which grows with the square of the roughness, and with each place that
/// seemed likely before and gave way to another one: so may the next.
class Proof {
 public:
  /// Roughness in m, that of MapQuality.
  explicit Proof(double roughness = 0.0)
      : way_(kWay * roughness * roughness / (kVeryRough * kVeryRough)) {}

  /// A place that somebody told needs none.
  void waive() {
    driven_.reset();
    suspect_way_ = 0.0;
    refuted_ = 0;
  }

  void demand() {
    driven_ = 0.0;
    suspect_way_ = 0.0;
  }

  /// In a search a likely place has given way to another one.
  void refute() { ++refuted_; }

  /// Of the place that is known now.
  void forgetRefuted() { refuted_ = 0; }

  /// The place may be another one that looks alike: until scans have gone on fitting for some way.
  void suspect() { suspect_way_ = kSuspectWay; }
  void trust() { suspect_way_ = 0.0; }
  bool isSuspect() const { return suspect_way_ > 0.0; }

  /// Demands on another map as much as was demanded before.
  void copyStateOf(const Proof& other) {
    driven_ = other.driven_;
    suspect_way_ = other.suspect_way_;
    refuted_ = other.refuted_;
  }

  /// Motion since the last scan. Where scans do not usually fit as a place explains them, driving
  /// on proves nothing.
  void drive(const Pose2& motion, bool usually_fits) {
    const double way = std::hypot(motion.x, motion.y);
    if (driven_) driven_ = usually_fits ? *driven_ + way : 0.0;
    if (usually_fits) suspect_way_ -= way;
  }

  /// As far as the map demands it, whatever gave way.
  bool isEnoughForTheMap() const { return !driven_ || *driven_ >= way_; }
  bool isGiven() const { return !driven_ || *driven_ >= way_ + kWayPerRefuted * refuted_; }

  /// Scans alone told the place.
  bool isByScans() const { return driven_.has_value(); }

 private:
  static constexpr double kSuspectWay = 5.0;   // m
  static constexpr double kWay = 7.0;          // m, where walls are as rough as
  static constexpr double kVeryRough = 0.075;  // m, those of a plan that does not fit the building
  static constexpr double kWayPerRefuted = 1.5;  // m

  double way_;                    // m
  std::optional<double> driven_;  // m, so far; nothing if none is needed
  double suspect_way_{0.0};       // m, left to drive
  int refuted_{0};                // places that gave way since one was known
};

}  // namespace adaptive_localization
