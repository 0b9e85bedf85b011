// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "localizer/hypotheses.hpp"
#include "localizer/tracking_odds.hpp"

namespace adaptive_localization {

/// A known place that a scan does not fit, from then until other places are known that explain the
/// scan. Until a scan fits the core's place, the doubted one is followed as scans show it:
/// odometry may be wrong.
class Doubt {
 public:
  Doubt(const Ground& ground, const Senses& senses) : followed_(ground, senses) {}

  bool isRaised() const { return T_map_base_.has_value(); }

  /// The place is the core's, or the one that is still followed.
  void raise(const Pose2& T_map_base, const TrackingOdds& odds);

  /// Others are known, or need not be.
  void end() { T_map_base_.reset(); }

  /// The place is followed no more.
  void forget() { followed_.clear(); }

  /// This place is followed from now on.
  void keep(const Pose2& T_map_base, const TrackingOdds& odds);

  void standOn(const Ground& ground, const Senses& senses) { followed_.standOn(ground, senses); }

  /// The robot drove so far.
  void ride(const Pose2& motion);

  /// Takes note of a scan, and of whether it fits the core's place.
  void count(bool fits);

  /// Moves the place that is followed to where the scan fits about it; the core's pose tells, too.
  void follow(const Pose2& T_map_core, const Scan& scan, double usual_error);

  /// Where the place was when it was doubted, as odometry moves it since then.
  const Pose2& byOdometry() const { return *T_map_base_; }

  /// As scans show it.
  Pose2 byScans() const {
    return followed_.isEmpty() ? byOdometry() : followed_.modes().front().T_map_base;
  }

  /// Scans since then, and how many of them did not fit.
  int scans() const { return scans_; }
  int misfits() const { return misfits_; }
  double shareOfMisfits() const { return std::max(1, misfits_) / (scans_ + 1.0); }

  /// Until now one thing that was moved can be all that spoils the scans.
  bool isBrief() const;

  /// After scans that did not fit, the core's place may give way to one nearby that looks like
  /// where the robot was carried: since the first of them it moved by more than odometry can be
  /// off.
  bool hasSlid(const Pose2& T_map_core) const;

 private:
  std::optional<Pose2> T_map_base_{};  // by odometry
  Hypotheses followed_;                // the same place, as scans show it; empty if it is not
  int scans_{0}, misfits_{0};
  double way_{0.0}, turn_{0.0};  // m and rad
};

}  // namespace adaptive_localization
