// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kept_place.hpp"
#include "localizer/search_pace.hpp"
#include "ser/place.hpp"
#include "ser/place_refiner.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kMostPlaces = 100;
// Places judged by each scan, where one leads, and at the most of those to be aligned with it.
constexpr std::size_t kLikeliest = 4, kInTurn = 4, kAtOnce = 40;
constexpr double kMargin = 6.0;        // log odds below the best at which a place is ruled out
constexpr double kScale = 0.1 / 15.0;  // m, for 15 independent beams
constexpr double kScaleShare = 0.25;
constexpr double kRough = 0.12;  // m, above: errors are the map's, alike for all scans nearby
constexpr double kMostWithoutFit = 1.0;  // of log odds, that a scan says which fits nowhere well,
constexpr double kMostOfKept = 0.2;      // and that it says of a kept place
constexpr double kMostBesideScan = 7.0;  // that a sense says in all, where the laser sees as well
constexpr double kPlaceVariance = 0.05 * 0.05;      // m^2, of a place aligned with a scan
constexpr double kPlaceTurnVariance = 0.03 * 0.03;  // rad^2

/// The likeliest of some hypotheses that is the same place as a pose, or the end.
template <class All>
auto at(All& all, const Pose2& T_map_base) {
  return std::find_if(all.begin(), all.end(), [&](const auto& hypothesis) {
    return areSamePlace(hypothesis.T_map_base, T_map_base);
  });
}

/// From one of these an alignment can end where it does not from the other.
bool isElsewhere(const Pose2& a, const Pose2& b) {
  constexpr double kNear = 0.1, kSame = 0.05;  // m, rad
  return distance(a, b) > kNear || std::abs(wrapAngle(a.theta - b.theta)) > kSame;
}

/// The same, or else one that a core can have drifted off from.
template <class All>
auto about(All& all, const Pose2& T_map_core) {
  constexpr double kDrift = 1.5, kTurn = 0.35;  // m, rad
  const auto same = at(all, T_map_core);
  if (same != all.end()) return same;
  return std::find_if(all.begin(), all.end(), [&](const auto& hypothesis) {
    const Pose2& pose = hypothesis.T_map_base;
    return distance(pose, T_map_core) < kDrift &&
           std::abs(wrapAngle(pose.theta - T_map_core.theta)) < kTurn;
  });
}

}  // namespace

Eigen::Matrix3d Hypotheses::placeCovariance() {
  return Eigen::Vector3d(kPlaceVariance, kPlaceVariance, kPlaceTurnVariance).asDiagonal();
}

void Hypotheses::add(const Pose2& T_map_base, double log_odds, const Eigen::Matrix3d& covariance) {
  const bool is_room = all_.size() < kMostPlaces;
  if (is_room && isFinite(T_map_base) && !knows(T_map_base)) {
    all_.push_back({T_map_base, log_odds});
    all_.back().covariance = covariance;
  }
}

void Hypotheses::addFound(const std::vector<Place>& places, double log_odds,
                          const Eigen::Matrix3d& covariance, bool are_aligned) {
  left_out_.reset();
  for (const Place& place : places) {
    const auto known = at(all_, place.T_map_base);
    if (known == all_.end() && all_.size() == kMostPlaces) {
      left_out_ = log_odds;
    } else if (known == all_.end()) {
      add(place.T_map_base, log_odds, covariance);
      if (are_aligned && !all_.empty()) all_.back().aligned = place;
    } else if (!known->T_map_found && isElsewhere(known->T_map_base, place.T_map_base)) {
      known->T_map_found = place.T_map_base;
    }
  }
}

/// Word rules out nothing.
double Hypotheses::bestBesidesWord() const {
  double best = -std::numeric_limits<double>::infinity();
  for (const Hypothesis& hypothesis : all_) {
    best = std::max(best, hypothesis.log_odds - hypothesis.word);
  }
  return best;
}

bool Hypotheses::lackSome() const {
  return left_out_ && *left_out_ >= bestBesidesWord() - kMargin;
}

bool Hypotheses::waitForSome() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Hypothesis& hypothesis) { return hypothesis.is_new; });
}

void Hypotheses::addKept(const Pose2& T_map_base, const TrackingOdds& odds) {
  if (!isFinite(T_map_base) || knows(T_map_base)) return;
  all_.push_back({T_map_base, odds.value(), odds.value(), odds.word(), odds.isKept(), true});
  T_map_kept_ = T_map_base;
}

bool Hypotheses::knows(const Pose2& T_map_base) const {
  return at(all_, T_map_base) != all_.end();
}

std::vector<Place> Hypotheses::explaining(const Observations& observations, double most) const {
  std::vector<Place> places;
  for (const Hypothesis& hypothesis : all_) {
    const Gaussian2 corrected = correctedBySenses(hypothesis, observations);
    const double error = senses_->misfit(observations, corrected.mean).value_or(most);
    if (error < most) places.push_back({hypothesis.T_map_base, error});
  }
  return places;
}

bool Hypotheses::hold(const Pose2& T_map_core, double error, double usual) const {
  const auto place = about(all_, T_map_core);
  if (place == all_.end()) return false;
  if (areSamePlace(place->T_map_base, T_map_core) || loss(error, usual) == 0.0) return true;
  return place->error > kFarBetter * error;
}

double Hypotheses::entry(double malus, const TrackingOdds& odds) const {
  double best = all_.empty() ? 0.0 : all_.front().log_odds;
  double told = 0.0;
  for (const Hypothesis& hypothesis : all_) {
    best = std::max(best, hypothesis.log_odds);
    const double prior = std::min(hypothesis.prior, odds.value());
    if (hypothesis.prior > 0.0) told = std::min(told, hypothesis.log_odds - prior);
  }
  return std::min(told, best - malus);
}

bool Hypotheses::isByWord() const {
  return std::any_of(all_.begin(), all_.end(), [&](const Hypothesis& hypothesis) {
    return hypothesis.word > 0.0 && !hypothesis.is_new;
  });
}

void Hypotheses::ride(const Pose2& motion) {
  for (Hypothesis& hypothesis : all_) {
    hypothesis.T_map_base = hypothesis.T_map_base * motion;
    hypothesis.way += wayOf(motion);
    hypothesis.T_map_found.reset();
  }
  T_map_kept_ = T_map_kept_ * motion;
}

void Hypotheses::moveKept(const Pose2& T_map_base) {
  for (Hypothesis& hypothesis : all_) {
    if (hypothesis.was_believed) hypothesis.T_map_base = T_map_base;
  }
  T_map_kept_ = T_map_base;
}

void Hypotheses::note(const Pose2& T_map_core) {
  const auto place = about(all_, T_map_core);
  if (place != all_.end()) place->T_map_core = T_map_core;
}

Eigen::ArrayXXd Hypotheses::scores(const Observations& observations) const {
  Particles places(static_cast<Eigen::Index>(all_.size()));
  for (std::size_t i = 0; i < all_.size(); ++i) {
    places.setPose(static_cast<Eigen::Index>(i), all_[i].T_map_base);
  }
  const auto& senses = senses_->parts();
  Eigen::ArrayXXd all =
      Eigen::ArrayXXd::Zero(places.size(), static_cast<Eigen::Index>(senses.size()));
  for (std::size_t k = 0; k < senses.size() && places.size() > 0; ++k) {
    auto column = all.col(static_cast<Eigen::Index>(k));
    senses[k]->score(observations, places, column);
    column -= column.maxCoeff();
  }
  return all;
}

/// Of log odds. Where walls are rough, the true place may fit worse than another.
double Hypotheses::loss(double error, double usual) const {
  const double level = std::max(least_error_, usual);
  const double share = kScaleShare * std::max(1.0, level / kRough);
  return std::max(0.0, error - tolerated(level)) / std::max(kScale, share * level);
}

double Hypotheses::tolerated(double level) const {
  return withTolerance(level) + ground_.field->quality().roughness();
}

/// Whether a place is so much likelier than all others that they would be ruled out, did they not
/// explain the scans.
bool Hypotheses::hasLeader() const {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  double best = kNone, second = kNone;
  for (const Hypothesis& hypothesis : all_) {
    second = std::max(second, std::min(best, hypothesis.log_odds));
    best = std::max(best, hypothesis.log_odds);
  }
  return best - second > kMargin;
}

/// Those that the scan judges; share is how much of it is new. What a search aligned with it costs
/// no more time.
void Hypotheses::choose(double share) {
  std::size_t room = hasLeader() ? kInTurn : kAtOnce, likeliest = 0, added = 0;
  std::vector<Hypothesis*> others;
  for (Hypothesis& hypothesis : all_) {
    hypothesis.share = std::min(1.0, hypothesis.share + share);
    ++hypothesis.waited;
    hypothesis.is_due = hypothesis.aligned.has_value() || hypothesis.T_map_core.has_value() ||
                        hypothesis.was_believed || (!hypothesis.is_new && likeliest++ < kLikeliest);
    if (hypothesis.is_due) continue;
    others.push_back(&hypothesis);
    added += hypothesis.is_new ? 1 : 0;
  }
  const auto before = [](const Hypothesis* a, const Hypothesis* b) {
    return std::make_pair(!a->is_new, -a->waited) < std::make_pair(!b->is_new, -b->waited);
  };
  std::stable_sort(others.begin(), others.end(), before);
  room = std::max(room, std::min(added, kAtOnce));
  if (others.size() > room) others.resize(room);
  for (Hypothesis* hypothesis : others) hypothesis->is_due = true;
}

double Hypotheses::lostBy(const PlaceRefiner& refiner, Hypothesis& hypothesis, bool fits,
                          double usual) const {
  double lost = loss(hypothesis.error, usual);
  if (!fits) lost = std::min(lost, hypothesis.is_kept ? kMostOfKept : kMostWithoutFit);
  hypothesis.is_explained = lost == 0.0;
  if (!hypothesis.is_kept) return lost;
  const double most = mostAgainst(refiner, hypothesis.T_map_base, hypothesis.word > 0.0, usual);
  hypothesis.is_spared = lost > most;
  return std::min(lost, most);
}

void Hypotheses::weigh(const Observations& observations, double share, double usual) {
  const Scan& scan = observations.scan;
  const bool is_seen = scan.hits() > 0;
  const PlaceRefiner refiner = refinerFor(scan);
  choose(share);
  is_seen ? align(refiner, usual) : correctBySenses(observations);
  if (is_seen && led_to_ && all_.size() < kMostPlaces) {
    all_.push_back(*led_to_);
    least_error_ = std::min(least_error_, led_to_->error);
  }
  const bool fits = least_error_ <= std::max(kGoodFit, withTolerance(usual));
  const Eigen::ArrayXXd told = scores(observations);
  for (std::size_t i = 0; i < all_.size(); ++i) {
    Hypothesis& hypothesis = all_[i];
    if (!hypothesis.is_due) continue;
    const bool is_found = hypothesis.is_new && !hypothesis.was_believed;
    const double worth = is_found ? 1.0 : hypothesis.share;
    if (is_seen) hypothesis.log_odds -= worth * lostBy(refiner, hypothesis, fits, usual);
    for (std::size_t k = 0; k < senses_->parts().size(); ++k) {
      const double by_sense = told(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
      const double most = senses_->parts()[k]->mostInAll();
      hypothesis.hear(k, worth * by_sense, is_seen ? std::min(most, kMostBesideScan) : most);
    }
    hypothesis.is_new = false;
    hypothesis.waited = 0;
    hypothesis.share = 0.0;
  }
}

/// A place that is spared does not rule out what explains the scan.
void Hypotheses::prune() {
  std::stable_sort(all_.begin(), all_.end(), [](const Hypothesis& a, const Hypothesis& b) {
    return a.log_odds > b.log_odds;
  });
  const double best = bestBesidesWord();
  const bool is_disputed = std::any_of(
      all_.begin(), all_.end(), [](const Hypothesis& hypothesis) { return hypothesis.is_spared; });
  std::vector<Hypothesis> before;
  before.swap(all_);
  for (const Hypothesis& hypothesis : before) {
    const bool is_likely = hypothesis.log_odds >= best - kMargin;
    const bool is_left = is_likely || (is_disputed && hypothesis.is_explained);
    const auto same = at(all_, hypothesis.T_map_base);
    if (same != all_.end()) {
      same->was_believed = same->was_believed || hypothesis.was_believed;
    } else if (is_left) {
      all_.push_back(hypothesis);
    } else if (hypothesis.was_believed) {
      is_kept_ruled_out_ = true;
    }
  }
}

bool Hypotheses::isOutdone(const Pose2& T_map_core) const {
  const auto core = at(all_, T_map_core);
  if (core == all_.end()) return false;
  const Hypothesis& best = all_.front();
  return best.log_odds - core->log_odds > kMargin && best.error < kFarBetter * core->error &&
         tolerated(best.error) < core->error;
}

std::vector<Mode> Hypotheses::modes() const {
  std::vector<Mode> modes;
  double best = 0.0, sum = 0.0;
  const bool is_any_judged = std::any_of(
      all_.begin(), all_.end(), [](const Hypothesis& hypothesis) { return !hypothesis.is_new; });
  for (const Hypothesis& hypothesis : all_) {
    if (hypothesis.is_new && is_any_judged) continue;
    if (modes.empty()) best = hypothesis.log_odds;
    modes.push_back(
        {hypothesis.T_map_base, hypothesis.covariance, std::exp(hypothesis.log_odds - best)});
    sum += modes.back().mass;
  }
  for (Mode& mode : modes) mode.mass /= sum;
  return modes;
}

}  // namespace adaptive_localization
