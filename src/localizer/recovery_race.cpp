// SPDX-License-Identifier: BSD-3-Clause
// The race between the places where the robot can be, from the doubt that opens it to the one place
// that is left.
#include <algorithm>
#include <exception>

#include "localizer/recovery.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLateMalus = 3.0, kCoreMalus = 5.5;  // of places that come late, of the core's
constexpr double kBesideWorth = 0.5;  // of a scan against a core a step beside its place

/// How far off is what sightings of landmarks explain.
Eigen::Matrix3d roughly() {
  constexpr double kVariance = 0.5 * 0.5, kTurnVariance = 0.2 * 0.2;  // m^2, rad^2
  return Eigen::Vector3d(kVariance, kVariance, kTurnVariance).asDiagonal();
}

}  // namespace

/// What was known of the place is void, and so is what was found of others.
void Recovery::beCarried(const Pose2& T_map_base) {
  settle();
  watch_.forgetNear();
  left_.reset();
  doubt_.forget();
  odds_.beCarried();
  proof_.demand();
  proof_.forgetRefuted();
  pace_.restart();
  status_ = Status::kLost;
  was_tracking_ = from_anywhere_ = false;
  doubt_.raise(T_map_base, odds_);
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
void Recovery::openDoubted(const Observations& observations) {
  const Pose2 T_map_then = doubt_.byOdometry(), T_map_now = doubt_.byScans();
  const Places::Asked* asked = ground_.places->askedBefore(observations);
  if (!asked) return open(T_map_now);
  open(T_map_then, inverse(asked->motion));
  hypotheses_.addAligned(asked->places, 0.0);
  const double share = doubt_.shareOfMisfits();
  hypotheses_.weigh(withoutCover(T_map_then, asked->observations),
                    {share, share, watch_.hasComeNear(), watch_.goesOn()}, usual_.value());
  hypotheses_.prune(against());
  pace_.explain(hypotheses_.leastError());
  hypotheses_.ride(asked->motion);
  hypotheses_.moveKept(T_map_now);
  novelty_.count();
  novelty_.ride(asked->motion);
}

/// What is still being searched for is of no more use: by then odometry would have drifted.
void Recovery::settle() {
  ground_.places->askAnew();
  is_settled_ = true;
  race_ = {};
  doubt_.end();
  novelty_.restart();
  hypotheses_.clear();
  modes_.clear();
}

/// If from one scan to the next none of the places that are compared fits any more, the robot was
/// carried away. Where memory runs out, a race that begins is off, and the place is as known as it
/// was.
void Recovery::compare(const Pose2& expected, const Pose2& T_map_base, double error,
                       const Observations& observations) {
  const bool was_settled = is_settled_;
  try {
    if (is_settled_ && isRaceDue(expected, T_map_base, error, observations)) {
      doubt_.isRaised() ? openDoubted(observations) : open(expected);
    } else if (is_settled_) {
      pace_.skipScan();
    }
    if (is_settled_) return;
    race(T_map_base, error, observations);
    if (has_left_leader_ && !race_.explained) return beCarried(T_map_base);
    if (is_settled_) watch_.forgetNear();
    if (is_settled_ && unexplained_ > 0) findNothingBetter(error);
  } catch (const std::exception&) {
    if (was_settled) settle();
    throw;
  }
}

/// Where the core believes to be, with the mean range error there, counts as well, whether the
/// search finds it or not. A place that is ruled out stays in the race until the one in its stead
/// is known as well: if that is doubted, it is one of those that are compared.
void Recovery::race(const Pose2& T_map_base, double error, const Observations& observations) {
  hypotheses_.note(T_map_base);
  hypotheses_.addCore(T_map_base, hypotheses_.entry(kCoreMalus, odds_));
  // while no place explains the scans each may be the one that tells, but searching is not free
  const bool has_places = race_.searched && race_.explained;
  if (!(has_places && hypotheses_.isByWord()) && pace_.isDue(has_places)) search(observations);
  News news = novelty_.news(observations.scan.view.width);
  news.is_sudden = watch_.hasComeNear();
  news.goes_on = watch_.goesOn();
  hypotheses_.weigh(observations, news, usual_.value());
  race_.alike = std::max(race_.alike, hypotheses_.alike(T_map_base));
  hypotheses_.prune(against());
  novelty_.count();
  modes_ = hypotheses_.modes();
  race_.most = std::max(race_.most, modes_.size());
  noteLeader();
  race_.explained =
      !modes_.empty() && hypotheses_.leastError() < std::max(kExplained, usual_.limit());
  if (!race_.explained) pace_.miss(hypotheses_.leastError());
  const bool is_elsewhere = !hypotheses_.hold(T_map_base, error, usual_.value());
  const bool is_beside = hypotheses_.isCoreBeside() || hypotheses_.isOutdone(T_map_base);
  const bool is_ruled_out = race_.explained && (is_elsewhere || is_beside);
  const double worth = is_elsewhere ? 1.0 : kBesideWorth * news.share;
  race_.contradictions = is_ruled_out ? race_.contradictions + worth : 0.0;
  race_.has_left = race_.has_left || mustMove();
  if (!left_ && (was_tracking_ || !from_anywhere_)) left_ = hypotheses_.ruledOut();
  const bool is_one = modes_.size() == 1 && !hypotheses_.waitForSome() &&
                      areSamePlace(modes_[0].T_map_base, T_map_base);
  if (!race_.searched || is_ruled_out || !is_one) return;
  if (searchAgain(observations)) return;
  if (hypotheses_.ruledOut()) leave();
  if (odds_.ruleOut(race_.alike)) proof_.trust();
  was_refuted_ = hypotheses_.refuted() > 0.0;
  were_many_ = areMany() || isOneOfMany();
  unexplained_ > 0 ? doubt_.keep(modes_[0].T_map_base, odds_) : doubt_.forget();
  settle();
  is_unchecked_ = initial_pose_.isCheckDue();
  odds_.find();
  pace_.searched(unexplained_ == 0, hypotheses_.leastError());
}

/// A likely place that gives way to another one in a search shows that scans do not tell them apart
/// so soon; one that was known, that the robot was carried away.
void Recovery::noteLeader() {
  constexpr double kLikely = 0.7;  // mass
  if (!isNew()) return race_.leader.reset();
  if (modes_.empty() || modes_.front().mass < kLikely) return;
  const Pose2& now = modes_.front().T_map_base;
  if (race_.leader && !areSamePlace(*race_.leader, now)) proof_.refute();
  race_.leader = now;
}

/// Whether the race goes on though one place is left, as the true one may not be among those that
/// were found. Then the map is searched again; for a new place that was one of several and fits no
/// scan as is usual, or was one of many, by other views.
bool Recovery::searchAgain(const Observations& observations) {
  const bool is_lacking =
      hypotheses_.lackSome(against()) || pace_.wasBlind(hypotheses_.leastError());
  const double as_usual = areMany() ? 0.0 : Hypotheses::withTolerance(usual_.value());
  const bool is_unsure = isNew() && race_.most > 1 && pace_.isUnsure(as_usual);
  if (is_lacking && isNew()) pace_.insist();
  if (is_lacking || (is_unsure && pace_.seesElse())) search(observations);
  return is_lacking || is_unsure;
}

/// What was known is of a place that is ruled out. If the wheels slipped from there, all others are
/// as unlikely as they were, and what told that place tells the new one.
void Recovery::leave() {
  if (hypotheses_.isBySlip()) return odds_.lose(Hypothesis::kSlip);
  odds_ = TrackingOdds();
  proof_.demand();
}

void Recovery::search(const Observations& observations) {
  const auto answer = placesFor(observations);
  if (!canSearch(observations) || !answer) return;
  const std::vector<Place>& places = *answer;
  initial_pose_.checked();
  is_unchecked_ = false;
  const double malus = race_.searched ? kLateMalus : 0.0;
  const double odds = race_.was_searched ? hypotheses_.entry(malus, odds_) : 0.0;
  if (observations.scan.hits() == 0) {
    hypotheses_.addFound(places, odds, roughly());
  } else if (ground_.places->askedBefore(observations)) {
    hypotheses_.addFound(places, odds);
  } else {
    hypotheses_.addAligned(places, odds);
  }
  const double error = places.empty() ? RangeError::kTruncation : places.front().error;
  pace_.searched(error < kExplained, error);
  race_.was_searched = race_.searched = race_.searched || !hypotheses_.isEmpty();
}

}  // namespace adaptive_localization
