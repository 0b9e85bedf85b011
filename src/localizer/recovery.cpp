// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/recovery.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "occlusion.hpp"
#include "ser/place.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {
namespace {

constexpr double kUnfit = 0.3;  // m, of a scan that tells of no place
constexpr double kWorse = 1.5;  // than the scan before, of one after the robot was carried
constexpr int kSpurious = 2;    // updates in a row that sightings of no landmark can explain

}  // namespace

Recovery::Recovery(const ConfidenceOptions& options, Ground ground, Senses senses)
    : ground_(ground),
      senses_(senses),
      range_error_(ground.map, ground.field),
      confidence_(options, ground.field, senses),
      usual_(ground.field->quality().rangeError()),
      hypotheses_(ground, senses),
      doubt_(ground, senses),
      proof_(ground.field->quality().roughness()) {}

void Recovery::reset(const Prior& prior) {
  const bool is_given = std::holds_alternative<Gaussian2>(prior);
  from_anywhere_ = std::holds_alternative<Anywhere>(prior);
  was_tracking_ = is_unchecked_ = false;
  proof_.waive();
  if (from_anywhere_) proof_.demand();
  left_.reset();
  leeway_.end();
  initial_pose_ = InitialPose(is_given);
  odds_ = TrackingOdds(is_given);
  unexplained_ = unfit_ = blind_ = 0;
  error_ = RangeError::kTruncation;  // the first scan is no worse
  pace_.restart();
  watch_ = {};
  has_left_leader_ = was_refuted_ = were_many_ = false;
  confidence_.reset();
  settle();
  doubt_.forget();
  is_settled_ = !from_anywhere_;
  status_ = Status::kGlobalizing;
}

void Recovery::copyStateOf(const Recovery& other) {
  Recovery next = other;
  next.ground_ = ground_;
  next.senses_ = senses_;
  next.range_error_ = range_error_;
  next.confidence_ = confidence_;
  next.confidence_.copyStateOf(other.confidence_);
  if (ground_.map != other.ground_.map) {
    next.usual_ = usual_;
    next.race_.searched = false;  // places that only this map has are as good as those known so far
    if (!next.odds_.isKept()) next.initial_pose_.checkNow();
  }
  next.proof_ = proof_;
  next.proof_.copyStateOf(other.proof_);
  next.hypotheses_.standOn(ground_, senses_);
  next.doubt_.standOn(ground_, senses_);
  *this = std::move(next);
}

Scan Recovery::evidenceOf(const Pose2& T_map_base, const Scan& scan) const {
  if (isCoveredAt(T_map_base, scan) || areTooShort(scan, T_map_base, range_error_)) return {};
  const bool is_clear = !ground_.field->quality().hasThickWalls();
  return is_clear && status_ == Status::kTracking
             ? withoutObstacles(scan, T_map_base, *ground_.field, range_error_)
             : scan;
}

void Recovery::ride(const Pose2& motion) {
  hypotheses_.ride(motion);
  doubt_.ride(motion);
  novelty_.ride(motion);
  if (race_.has_left) race_.left_way += std::hypot(motion.x, motion.y);
  if (left_) left_ = *left_ * motion;
  leeway_.ride(motion);
  if (race_.leader) race_.leader = *race_.leader * motion;
  if (is_settled_ && odds_.isKept()) {
    left_.reset();
    proof_.forgetRefuted();
  }
  pace_.travel(wayOf(motion));
  initial_pose_.travel(wayOf(motion));
  odds_.checkJump(motion);
}

void Recovery::observe(const Pose2& motion, const Pose2& T_map_base_expected,
                       const Estimate& estimate, const Observations& all) {
  const Pose2& T_map_base = estimate.T_map_base;
  const Observations observations = withoutCover(T_map_base, all);
  scan_fits_ = false;
  if (!tells(observations)) return seeNothing(estimate, all);
  blind_ = 0;
  confidence_.observe(estimate, observations);
  if (isGarbled(T_map_base, observations.scan)) odds_.seeNothing(motion);
  const double error = errorAt(T_map_base, observations);
  const bool is_nowhere = !is_settled_ && odds_.areSpent();  // what the race is between is void
  const bool fits_on = !is_nowhere && error <= kWorse * std::max(error_, usual_.value());
  if (watch_.tellCarrying() && !fits_on) beCarried(T_map_base_expected);
  const bool is_sudden = isSudden(T_map_base, observations.scan, error);
  if (is_sudden) watch_.breakOff();
  if (is_sudden && is_settled_) proof_.suspect();
  has_left_leader_ = is_sudden && !is_settled_;
  error_ = error;
  scan_fits_ = error <= usual_.limit();
  if (scan_fits_) watch_.forgetNear();
  if (scan_fits_) watch_.fit(motion);
  unexplained_ = scan_fits_ ? 0 : unexplained_ + 1;
  if (is_settled_) doubt_.count(scan_fits_);
  if (is_settled_ && was_tracking_ && doubt_.hasSlid(T_map_base)) proof_.suspect();
  if (unexplained_ == 1) ground_.places->askAnew();
  unfit_ = error > kUnfit ? unfit_ + 1 : 0;
  if (unexplained_ == 0) {
    was_refuted_ = false;
    learn(error);
    if (is_settled_ && !doubt_.isRaised()) proof_.drive(motion, usual_.value() <= kExplained);
    if (!isAtALoss() && !confidence_.isContradicted()) pace_.restart();
    if (isEarned(error)) odds_.earn(motion);
    const bool only_waits = doubt_.isRaised() && error < kExplained;  // until others are found
    if (status_ == Status::kLost && !only_waits) odds_.loseWay(motion, error > kUnfit);
  }
  if (!doubt_.isRaised() && unexplained_ == 0) doubt_.forget();
  doubt_.follow(T_map_base, observations.scan, usual_.value());
  compare(T_map_base_expected, T_map_base, error, observations);
  noteLeeway(estimate);
  keepUp(T_map_base, observations);
  updateStatus();
}

bool Recovery::isUnverified(const Observations& observations) const {
  return initial_pose_.isUnverified() && canSearch(observations);
}

void Recovery::verify(const Estimate& estimate, const Observations& all) {
  const Observations observations = withoutCover(estimate.T_map_base, all);
  if (!tells(observations)) return;
  open(estimate.T_map_base);
  const double error = errorAt(estimate.T_map_base, observations);
  race(estimate.T_map_base, error, observations);
  updateStatus();
}

/// A doubt waits until it is known where else the robot can be.
bool Recovery::isRaceDue(const Pose2& expected, const Pose2& T_map_base, double error,
                         const Observations& observations) {
  if (initial_pose_.isUnverified() || hasJumped(expected, T_map_base)) return true;
  const bool is_seen = observations.scan.hits() > 0;
  const bool is_clearer = isAtALoss() && is_seen && pace_.tellsMore(error);
  if (!doubt_.isRaised() &&
      (is_clearer || isCheckDue(observations) || isDoubtful(error, is_seen))) {
    doubt_.raise(expected, odds_);
  }
  if (doubt_.isRaised() && is_seen && canSearch(observations) && isPatient(error)) {
    ground_.places->ask(observations);
    return false;
  }
  if (doubt_.isRaised()) return isAnswered(observations);
  return isOutvoted(T_map_base, error, observations);
}

/// One thing that was moved spoils a few scans: a place that was told, or tracked for long, is not
/// compared with others by these alone, unless a scan fits far worse, much came into view at once,
/// or the place may only look alike.
bool Recovery::isPatient(double error) const {
  const bool is_mild = doubt_.misfits() > 0 && error <= kFarWorse * usual_.limit();
  const bool is_sure = !isNew() && !proof_.isSuspect() && !left_ && status_ != Status::kLost;
  return is_sure && is_mild && !watch_.hasComeNear() && doubt_.isBrief();
}

/// Nobody doubts the pose: until there is a grid for a laser that came later, that can wait.
bool Recovery::isCheckDue(const Observations& observations) const {
  const bool is_seen = observations.scan.hits() > 0;
  return initial_pose_.isCheckDue() &&
         (!is_seen || ground_.places->energyGrid(observations.scan) != nullptr);
}

bool Recovery::hasJumped(const Pose2& expected, const Pose2& T_map_base) const {
  const bool had_place = was_tracking_ || from_anywhere_;  // by scans, not by somebody's word
  return had_place && !areSamePlace(expected, T_map_base);
}

/// From one scan to the next the core's place, tracked or the likeliest, fits far worse, and beams
/// go on through walls of the map, as they do not where people stand: the robot may have been
/// carried to a place that looks alike. Of 58 tracked robots that were carried and did not see it
/// otherwise, 54 saw that; of 6500 scans of robots that were not carried, 5.
bool Recovery::isSudden(const Pose2& T_map_base, const Scan& scan, double error) const {
  constexpr double kFarWorseThanLast = 2.0, kThrough = 0.05;  // of the beams
  const bool was_known = is_settled_ ? status_ == Status::kTracking
                                     : race_.leader && areSamePlace(*race_.leader, T_map_base);
  if (!was_known || error <= usual_.limit()) return false;
  return error > kFarWorseThanLast * std::max(error_, usual_.value()) &&
         range_error_.at(T_map_base, scan).throughShare() > kThrough;
}

/// Where a scan does not fit, other places are worth a thought: not at each scan as long as no
/// other place is better.
bool Recovery::isDoubtful(double error, bool is_seen) const {
  return (unexplained_ > (is_seen ? 0 : kSpurious) || isAtALoss()) && pace_.isOver(error);
}

}  // namespace adaptive_localization
