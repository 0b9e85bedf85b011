// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "map/range_error.hpp"
#include "ser/place.hpp"

namespace adaptive_localization {

/// Of a place aligned with a scan.
Eigen::Matrix3d placeCovariance();

/// A place where the robot may be, and what is known of it: one of the Hypotheses.
struct Hypothesis {
  static constexpr double kSlip = 4.0;  // log odds: so much less likely than none is a slip

  Pose2 T_map_base;
  double log_odds{0.0};
  double prior{0.0};  // of the odds, before any scan
  double word{0.0};   // of the odds, what no scan told: somebody did, or it is but a slip away
  bool is_kept{false};
  bool was_believed{false};  // it was the only one before the others were looked for
  bool has_slipped{false};   // from there, or from where that one slipped to
  std::optional<Pose2> T_map_core{}, T_map_found{};  // for the next scan
  std::optional<Place> aligned{};                    // with the next scan
  std::optional<Pose2> T_map_fitted{};  // by odometry since a scan fitted, if the last one does not
  Pose2 T_map_ridden{};             // by odometry alone, before it was aligned with the last scan
  Pose2 T_map_start = T_map_base;   // where it was half a metre or radian ago, or less
  Pose2 T_map_rolled = T_map_base;  // by odometry alone since then, on a way
  double rolled{0.0}, turned{0.0};  // of so many m and rad
  bool is_new{true};                // not judged yet: a scan counts in full
  bool is_due{true};                // to be judged by this scan
  int waited{0};                    // scans since it was judged,
  double share{0.0};                // and how much of them was new
  double error{RangeError::kTruncation};  // of the last scan, m
  bool is_explained{false};               // it speaks against no place less
  bool is_spared{false};  // it would rule the place out, were it not kept and did not most fit
  // It is kept, but most of the scan does not fit, or it fits nowhere and elsewhere twice as well.
  bool is_refuted{false};
  double refuted{0.0};           // of the odds, what it lost to scans that refuted it
  std::vector<double> sensed{};  // of the odds, what each other sense than the laser says
  Eigen::Matrix3d covariance = placeCovariance();
  double way{0.0};  // m or rad, since it was corrected by other senses

  /// The place that was believed in, or where the wheels slipped to from there.
  bool isKnown() const { return was_believed || has_slipped; }

  /// Odometry rolls on.
  void ride(const Pose2& motion) {
    constexpr double kLately = 0.5;  // m, or rad
    if (std::max(rolled, turned) > kLately) moveTo(T_map_base);
    T_map_base = T_map_base * motion;
    T_map_rolled = T_map_rolled * motion;
    rolled += std::hypot(motion.x, motion.y);
    turned += std::abs(motion.theta);
    way += wayOf(motion);
    T_map_found.reset();
    if (T_map_fitted) T_map_fitted = *T_map_fitted * motion;
  }

  /// It was aligned with the last scan, and fits it or not: then that may have led it astray,
  /// though to no other place.
  void settleAt(const Place& place, bool fits) {
    T_map_base = place.T_map_base;
    error = place.error;
    if (!T_map_fitted) T_map_fitted = T_map_ridden;
    if (fits || !areSamePlace(*T_map_fitted, T_map_base)) T_map_fitted.reset();
  }

  void moveTo(const Pose2& T_map_moved) {
    T_map_base = T_map_moved;
    rollFrom(T_map_moved);
  }

  /// Where wheels can slip to is measured from here on.
  void rollFrom(const Pose2& T_map_known) {
    T_map_rolled = T_map_start = T_map_known;
    rolled = turned = 0.0;
  }

  /// How far it would have moved off its way, to be at a position, against how far wheels can slip:
  /// more than 1 is no slip. Wheels that spin leave it anywhere on that way.
  double shiftTo(const Pose2& pose) const {
    constexpr double kOff = 0.3, kPerWay = 0.3, kPerTurn = 0.2;  // m, m/m, m/rad
    const Eigen::Vector2d roll(T_map_rolled.x - T_map_start.x, T_map_rolled.y - T_map_start.y);
    const Eigen::Vector2d shift(pose.x - T_map_start.x, pose.y - T_map_start.y);
    const double square = std::max(roll.squaredNorm(), std::numeric_limits<double>::min());
    const double rolled_on = std::clamp(shift.dot(roll) / square, 0.0, 1.0);
    return (shift - rolled_on * roll).norm() / (kOff + kPerWay * rolled + kPerTurn * turned);
  }

  /// The same for a pose.
  double slideTo(const Pose2& pose) const {
    constexpr double kTurned = 0.25;  // rad
    const double turn = std::abs(wrapAngle(pose.theta - T_map_rolled.theta));
    return std::max(shiftTo(pose), turn / (kTurned + turned));
  }

  /// The wheels slipped from here to another place, which no scan told from all others yet.
  Hypothesis slippedTo(const Pose2& T_map_slipped) const {
    Hypothesis slip{T_map_slipped, log_odds - kSlip};
    slip.word = std::max(0.0, slip.log_odds);
    slip.has_slipped = true;
    return slip;
  }

  /// Takes note of a log likelihood that a sense other than the laser tells of it; of all that
  /// it tells `most` counts.
  void hear(std::size_t sense, double told, double most) {
    if (sensed.size() <= sense) sensed.resize(sense + 1, 0.0);
    const double before = std::exchange(sensed[sense], std::max(-most, sensed[sense] + told));
    log_odds += sensed[sense] - before;
  }
};

/// The likeliest of some hypotheses that is the same place as a pose, or the end.
template <class All>
auto placeAt(All& all, const Pose2& T_map_base) {
  return std::find_if(all.begin(), all.end(), [&](const auto& hypothesis) {
    return areSamePlace(hypothesis.T_map_base, T_map_base);
  });
}

}  // namespace adaptive_localization
