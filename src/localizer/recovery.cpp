// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/recovery.hpp"

#include <algorithm>
#include <cmath>

#include "adaptive_localization/ser/place.hpp"
#include "adaptive_localization/ser/places.hpp"
#include "occlusion.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLateMalus = 3.0, kCoreMalus = 5.5;  // of places that come late, of the core's
constexpr double kUnfit = 0.3;                        // m, of a scan that tells of no place
constexpr double kNewWay = 0.3;       // m or rad, after which a scan is new evidence
constexpr double kBesideWorth = 0.5;  // of a scan against a core a step beside its place
constexpr int kSpurious = 2;          // updates in a row that sightings of no landmark can explain

/// How far off is what sightings of landmarks explain.
Eigen::Matrix3d roughly() {
  constexpr double kVariance = 0.5 * 0.5, kTurnVariance = 0.2 * 0.2;  // m^2, rad^2
  return Eigen::Vector3d(kVariance, kVariance, kTurnVariance).asDiagonal();
}

}  // namespace

Recovery::Recovery(const ConfidenceOptions& options, Ground ground, Senses senses)
    : ground_(ground),
      senses_(senses),
      range_error_(ground.map, ground.field),
      confidence_(options, ground.field, senses),
      usual_(ground.field->quality().rangeError()),
      hypotheses_(ground, senses),
      proof_(ground.field->quality().roughness()) {}

void Recovery::reset(const Prior& prior) {
  const bool is_told = std::holds_alternative<Gaussian2>(prior);
  from_anywhere_ = std::holds_alternative<Anywhere>(prior);
  was_tracking_ = is_unchecked_ = false;
  from_anywhere_ ? proof_.demand() : proof_.waive();
  left_.reset();
  told_ = ToldPose(is_told);
  odds_ = TrackingOdds(is_told);
  unexplained_ = unfit_ = 0;
  pace_.restart();
  confidence_.reset();
  settle();
  is_settled_ = !from_anywhere_;
  status_ = Status::kGlobalizing;
}

void Recovery::goOnFrom(const Recovery& other) {
  Recovery next = other;
  next.ground_ = ground_;
  next.senses_ = senses_;
  next.range_error_ = range_error_;
  next.confidence_ = confidence_;
  next.confidence_.goOnFrom(other.confidence_);
  if (ground_.map != other.ground_.map) next.usual_ = usual_;
  next.proof_ = proof_;
  next.proof_.goOnFrom(other.proof_);
  next.hypotheses_.standOn(ground_, senses_);
  *this = std::move(next);
}

Scan Recovery::evidenceOf(const Pose2& T_map_base, const Scan& scan) const {
  if (isOccluded(scan, T_map_base, range_error_)) return {};
  const bool is_clear = !ground_.field->quality().hasThickWalls();
  return is_clear && status_ == Status::kTracking
             ? withoutObstacles(scan, T_map_base, *ground_.field, range_error_)
             : scan;
}

void Recovery::observe(const Pose2& motion, const Pose2& T_map_base_expected,
                       const Estimate& estimate, const Observations& all) {
  const Observations observations = withoutCover(all);
  const Pose2& T_map_base = estimate.T_map_base;
  confidence_.observe(estimate, tells(observations) ? observations : all);
  hypotheses_.ride(motion);
  way_ += wayOf(motion);
  if (has_left_) left_way_ += std::hypot(motion.x, motion.y);
  if (left_) left_ = *left_ * motion;
  if (in_doubt_) in_doubt_ = *in_doubt_ * motion;
  if (is_settled_ && odds_.isKept()) left_.reset();
  pace_.travel(wayOf(motion));
  told_.travel(wayOf(motion));
  odds_.checkJump(motion);
  scan_fits_ = false;
  if (!tells(observations)) {
    ground_.places->askAnew();
    odds_.seeNothing();
    return conclude();
  }
  if (confidence_.contradictions() >= kContradictions) odds_.seeNothing();  // garbage, say
  const double error = errorAt(T_map_base, observations);
  scan_fits_ = error <= usual_.limit();
  unexplained_ = scan_fits_ ? 0 : unexplained_ + 1;
  if (unexplained_ == 1) ground_.places->askAnew();
  unfit_ = error > kUnfit ? unfit_ + 1 : 0;
  if (unexplained_ == 0) {
    if (!is_settled_) {
      usual_.observe(std::min(error, hypotheses_.mostTolerated()));
    } else if (status_ == Status::kTracking || status_ == Status::kAmbiguous) {  // not while lost
      usual_.observe(error);
    }
    if (is_settled_) proof_.drive(motion, usual_.value() <= kExplained);
    if (!isAtALoss() && !confidence_.isGainsaid()) pace_.restart();
    if (status_ == Status::kTracking && !in_doubt_) odds_.earn(motion);
    if (status_ == Status::kLost) odds_.loseWay(motion);
  }
  if (is_settled_ && isRaceDue(T_map_base_expected, T_map_base, error, observations)) {
    in_doubt_ ? openDoubted() : open(T_map_base_expected);
  } else if (is_settled_) {
    pace_.skipScan();
  }
  if (!is_settled_) {
    race(T_map_base, error, observations);
    if (is_settled_ && unexplained_ > 0) {
      usual_.observe(error);
      pace_.findNothingBetter(error);
    }
  }
  conclude();
}

bool Recovery::isUnverified(const Observations& observations) const {
  return told_.isUnverified() && canSearch(observations);
}

void Recovery::verify(const Estimate& estimate, const Observations& all) {
  const Observations observations = withoutCover(all);
  if (!tells(observations)) return;
  open(estimate.T_map_base);
  const double error = errorAt(estimate.T_map_base, observations);
  race(estimate.T_map_base, error, observations);
  conclude();
}

/// A doubt waits until it is known where else the robot can be.
bool Recovery::isRaceDue(const Pose2& expected, const Pose2& T_map_base, double error,
                         const Observations& observations) {
  if (told_.isUnverified() || hasJumped(expected, T_map_base)) return true;
  const bool is_seen = observations.scan.hits() > 0;
  if (!in_doubt_ && (told_.isCheckDue() || isDoubtful(error, is_seen))) in_doubt_ = expected;
  if (in_doubt_) return isAnswered(observations);
  return isOutvoted(T_map_base, error, observations);
}

bool Recovery::hasJumped(const Pose2& expected, const Pose2& T_map_base) const {
  const bool had_place = was_tracking_ || from_anywhere_;  // by scans, not by somebody's word
  return had_place && !areSamePlace(expected, T_map_base);
}

/// Where a scan does not fit, other places are worth a thought: not at each scan as long as no
/// other place is better.
bool Recovery::isDoubtful(double error, bool is_seen) const {
  return (unexplained_ > (is_seen ? 0 : kSpurious) || isAtALoss()) && pace_.isOver(error);
}

/// By a scan that was taken a motion `back` from here.
void Recovery::open(const Pose2& T_map_base, const Pose2& back) {
  settle();
  is_settled_ = false;
  pace_.begin();
  hypotheses_.addKept(T_map_base * back, odds_);
  if (left_) hypotheses_.add(*left_ * back, 0.0);
}

/// The scan that raised a doubt speaks against the doubted place, others since then may not: where
/// it took more than one update to search for others, that scan is weighed first.
void Recovery::openDoubted() {
  const Pose2 T_map_base = *in_doubt_;
  const std::optional<Places::Asked>& asked = ground_.places->askedBefore();
  if (!asked) return open(T_map_base);
  open(T_map_base, inverse(asked->motion));
  hypotheses_.addAligned(asked->places, 0.0);
  hypotheses_.weigh(withoutCover(asked->observations), 1.0, usual_.value());
  hypotheses_.prune();
  pace_.explain(hypotheses_.leastError());
  hypotheses_.ride(asked->motion);
  way_ = wayOf(asked->motion);
}

void Recovery::settle() {
  is_settled_ = true;
  searched_ = explained_ = has_left_ = false;
  in_doubt_.reset();
  left_way_ = 0.0;
  contradictions_ = 0;
  way_ = kNewWay;  // the first scan counts in full
  hypotheses_.clear();
  modes_.clear();
}

/// Where the core believes to be, with the mean range error there, counts as well, whether the
/// search finds it or not. A place that is ruled out stays in the race until the one in its stead
/// is known as well: if that is doubted, it is one of those that are compared.
void Recovery::race(const Pose2& T_map_base, double error, const Observations& observations) {
  hypotheses_.note(T_map_base);
  if (!hypotheses_.isEmpty()) hypotheses_.add(T_map_base, hypotheses_.entry(kCoreMalus, odds_));
  // while no place explains the scans each may be the one that tells, but searching is not free
  const bool has_places = searched_ && explained_;
  if (!(has_places && hypotheses_.isByWord()) && pace_.isDue(has_places)) search(observations);
  const double share = std::min(1.0, way_ / kNewWay);
  hypotheses_.weigh(observations, share, usual_.value());
  hypotheses_.prune();
  way_ = 0.0;
  modes_ = hypotheses_.modes();
  explained_ = !modes_.empty() && hypotheses_.leastError() < std::max(kExplained, usual_.limit());
  const bool is_elsewhere = !hypotheses_.hold(T_map_base, error, usual_.value());
  const bool is_beside = hypotheses_.isCoreBeside() || hypotheses_.isOutdone(T_map_base);
  const bool is_ruled_out = explained_ && (is_elsewhere || is_beside);
  const double worth = is_elsewhere ? 1.0 : kBesideWorth * share;
  contradictions_ = is_ruled_out ? contradictions_ + worth : 0.0;
  has_left_ = has_left_ || mustMove();
  if (!left_ && (was_tracking_ || !from_anywhere_)) left_ = hypotheses_.ruledOut();
  const bool is_one = modes_.size() == 1 && areSamePlace(modes_[0].T_map_base, T_map_base);
  if (!searched_ || is_ruled_out || !is_one) return;
  const bool were_all_compared =
      !hypotheses_.lackSome() && !pace_.wasBlind(hypotheses_.leastError());
  if (!were_all_compared) return search(observations);
  if (hypotheses_.ruledOut()) {
    odds_ = TrackingOdds();  // those were of that place
    proof_.demand();
  }
  settle();
  is_unchecked_ = told_.isCheckDue();
  odds_.find();
  pace_.searched(unexplained_ == 0, hypotheses_.leastError());
}

void Recovery::search(const Observations& observations) {
  const auto answer = placesFor(observations);
  if (!canSearch(observations) || !answer) return;
  const std::vector<Place>& places = *answer;
  told_.checked();
  is_unchecked_ = false;
  const double odds = searched_ ? hypotheses_.entry(kLateMalus, odds_) : 0.0;
  if (observations.scan.hits() == 0) {
    hypotheses_.addFound(places, odds, roughly());
  } else if (ground_.places->askedBefore()) {
    hypotheses_.addFound(places, odds);
  } else {
    hypotheses_.addAligned(places, odds);
  }
  const double error = places.empty() ? RangeError::kTruncation : places.front().error;
  pace_.searched(error < kExplained, error);
  searched_ = searched_ || !hypotheses_.isEmpty();
}

void Recovery::conclude() {
  status_ = judge();
  was_tracking_ = was_tracking_ || (is_settled_ && status_ == Status::kTracking);
}

/// An initial pose is not "tracking" before a scan could contradict it, nor after some way on which
/// no scan told it from all others; nor is a place that hardly explains the scans, however usual
/// such scans are: so badly they fit many another; nor one of a lost robot while others are being
/// searched for. A place that scans alone told is one of several until it is proven.
Status Recovery::judge() const {
  if (told_.isUnverified()) return Status::kGlobalizing;
  const Status nowhere = from_anywhere_ && !was_tracking_ ? Status::kGlobalizing : Status::kLost;
  const bool is_taken = hypotheses_.isByWord() && told_.isFresh() && unexplained_ == 0;
  if (!is_settled_ && !is_taken) {
    const bool fits = confidence_.latestFit() >= kFoundFit;
    return fits && modes_.size() > 1 ? Status::kAmbiguous : nowhere;
  }
  const bool was_lost = status_ == Status::kLost || !was_tracking_;
  if (was_lost && in_doubt_) return nowhere;
  const double fit = was_lost ? confidence_.latestFit() : confidence_.fit();
  const bool fits = fit >= (was_lost ? kFoundFit : Confidence::kContradiction);
  if (std::max(unfit_, confidence_.contradictions()) >= kContradictions) return nowhere;
  if (!confidence_.isCompact()) return nowhere;
  if (confidence_.isAmbiguous()) return Status::kAmbiguous;
  if (!fits) return nowhere;
  return proof_.isGiven() && !is_unchecked_ ? Status::kTracking : Status::kAmbiguous;
}

}  // namespace adaptive_localization
