// SPDX-License-Identifier: BSD-3-Clause
// What the localizer makes of scans, filter and rivals: when to update, when to doubt, what to say.
#include <Eigen/Dense>
#include <cmath>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/localizer/localizer.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLostFit = 0.2;   // below: the scan contradicts the map
constexpr double kFoundFit = 0.5;  // above: it confirms it
constexpr int kLostScans = 2;      // contradictions in a row that raise doubts

bool isSmallStep(const Pose2& from, const Pose2& to) {
  constexpr double kSmall = 0.1;  // m, rad
  const Pose2 step = between(from, to);
  return std::hypot(step.x, step.y) < kSmall && std::abs(step.theta) < kSmall;
}

/// Particles around places, as many around each as its mass says.
Particles drawFrom(const std::vector<Mode>& modes, Eigen::Index count, Rng& rng) {
  Particles particles(count);
  double upto = 0.0;
  Eigen::Index i = 0;
  for (const Mode& mode : modes) {
    upto += mode.mass * static_cast<double>(count);
    const Eigen::Vector3d deviation = mode.covariance.diagonal().cwiseSqrt();
    for (; i < count && static_cast<double>(i) < upto; ++i) {
      particles.setPose(i, {rng.normal(mode.T_map_base.x, deviation.x()),
                            rng.normal(mode.T_map_base.y, deviation.y()),
                            wrapAngle(rng.normal(mode.T_map_base.theta, deviation.z()))});
    }
  }
  for (; i > 0 && i < count; ++i) particles.setPose(i, particles.pose(0));  // masses rounded down
  return particles;
}

}  // namespace

std::string toText(Status status) {
  switch (status) {
    case Status::kGlobalizing:
      return "globalizing";
    case Status::kTracking:
      return "tracking";
    case Status::kAmbiguous:
      return "ambiguous";
    case Status::kLost:
      return "lost";
    default:
      return "uninitialised";
  }
}

/// A scan that contradicts the map opens it too: a robot that was carried away stands still.
bool Localizer::gateOpens(const Pose2& motion, const Observations& observations) const {
  if (std::hypot(motion.x, motion.y) >= setup_.options.update_min_d) return true;
  if (std::abs(motion.theta) >= setup_.options.update_min_a) return true;
  return observations.scan.hits() > 0 &&
         confidence_->fitOf(last_.estimate.T_map_base * motion, observations.scan) < kLostFit;
}

/// A robot that was known to be somewhere is there until that place is ruled out and another one,
/// that explains the scan well, is likelier than all others: what a filter makes of a blocked laser
/// is no reason to jump.
bool Localizer::isCorrection(const Pose2& T_map_base_by_odometry) const {
  constexpr double kRuledOut = 0.05;  // mass
  constexpr double kLikely = 0.5;     // mass
  constexpr double kWell = 0.1;       // m
  if (!converged_ || last_.status == Status::kTracking) return true;
  if (last_.status != Status::kAmbiguous) return false;
  if (isSmallStep(T_map_base_by_odometry, last_.estimate.T_map_base)) return true;
  return rivals_->leastError() < kWell && rivals_->shareOf(T_map_base_by_odometry) < kRuledOut &&
         rivals_->shareOf(last_.estimate.T_map_base) > kLikely;
}

/// Where the filter is; or, as long as that is no reason to jump, where odometry says and, if that
/// is one of two or three likely places, what scans make of it.
Pose2 Localizer::corrected(const Pose2& T_map_base_by_odometry) const {
  if (isCorrection(T_map_base_by_odometry)) return last_.estimate.T_map_base;
  constexpr double kFair = 0.3;  // mass
  if (last_.status != Status::kAmbiguous) return T_map_base_by_odometry;
  for (const Mode& mode : rivals_->modes()) {
    const bool is_held = isSmallStep(T_map_base_by_odometry, mode.T_map_base);
    if (is_held && mode.mass > kFair) return mode.T_map_base;
  }
  return T_map_base_by_odometry;
}

/// Moves the filter to the places that are left, once they rule out its own.
void Localizer::relocalize() {
  if (!setup_.options.relocalize || rivals_->contradictions() < kLostScans) return;
  constexpr Eigen::Index kParticles = 2000;
  Rng rng = Rng(static_cast<std::uint64_t>(setup_.options.seed)).split(++relocalizations_);
  filter_->reset(Prior(drawFrom(rivals_->modes(), kParticles, rng)));
  last_.estimate = filter_->estimate();
}

/// Where scans contradict the map, or the filter jumps, other places are worth a thought.
bool Localizer::isDoubtful(const Pose2& T_map_base_expected) const {
  const bool jumped = !areSamePlace(T_map_base_expected, last_.estimate.T_map_base);
  const bool had_place = converged_ || from_anywhere_;  // by scans, not by an initial pose's word
  return confidence_->contradictions() >= kLostScans || (had_place && jumped);
}

/// Somebody who says where the robot is may be wrong: the first scan tells, if another place
/// explains it and that one does not; where both do, scans on the way are asked, ever farther
/// apart.
void Localizer::checkWhatWasTold(const Pose2& motion, const Observations& observations) {
  way_to_check_ -= std::hypot(motion.x, motion.y) + std::abs(motion.theta);
  if (!is_told_ || way_to_check_ > 0.0 || !rivals_->isSettled()) return;
  const Pose2& T_map_base = last_.estimate.T_map_base;
  const Verdict verdict = rivals_->judge(T_map_base, observations);
  is_unverified_ = is_unverified_ && !ground_.places->isReadyFor(observations.scan);
  if (verdict == Verdict::kUnknown) return;
  is_told_ = verdict == Verdict::kPossible;
  way_to_check_ = way_of_checks_;
  way_of_checks_ *= 1.5;
  if (verdict != Verdict::kWrong) return;
  rivals_->open(T_map_base);
  rivals_->observe({}, T_map_base, observations);
}

/// An initial pose is not "tracking" before a scan could contradict it.
Status Localizer::judge() const {
  if (!rivals_->isSettled()) {
    const bool fits = confidence_->latestFit() >= kFoundFit;
    if (fits && rivals_->modes().size() > 1) return Status::kAmbiguous;
    return from_anywhere_ && !converged_ ? Status::kGlobalizing : Status::kLost;
  }
  if (is_unverified_) return Status::kGlobalizing;
  const bool was_lost = last_.status == Status::kLost || !converged_;
  const double fit = was_lost ? confidence_->latestFit() : confidence_->fit();
  const bool fits = fit >= (was_lost ? kFoundFit : kLostFit);
  if (confidence_->isCompact() && confidence_->isAmbiguous()) return Status::kAmbiguous;
  if (confidence_->isCompact() && fits) return Status::kTracking;
  return from_anywhere_ && !converged_ ? Status::kGlobalizing : Status::kLost;
}

}  // namespace adaptive_localization
