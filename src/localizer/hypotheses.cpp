// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ser/place.hpp"

namespace adaptive_localization {
namespace {

constexpr double kPlaceVariance = 0.05 * 0.05;      // m^2, of a place aligned with a scan
constexpr double kPlaceTurnVariance = 0.03 * 0.03;  // rad^2

/// From one of these an alignment can end where it does not from the other.
bool isElsewhere(const Pose2& a, const Pose2& b) {
  constexpr double kNear = 0.04, kSame = 0.02;  // m, rad
  return distance(a, b) > kNear || std::abs(wrapAngle(a.theta - b.theta)) > kSame;
}

/// The same, or else one that a core can have drifted off from.
template <class All>
auto about(All& all, const Pose2& T_map_core) {
  constexpr double kDrift = 1.5, kTurn = 0.35;  // m, rad
  const auto same = placeAt(all, T_map_core);
  if (same != all.end()) return same;
  return std::find_if(all.begin(), all.end(), [&](const auto& hypothesis) {
    const Pose2& pose = hypothesis.T_map_base;
    return distance(pose, T_map_core) < kDrift &&
           std::abs(wrapAngle(pose.theta - T_map_core.theta)) < kTurn;
  });
}

}  // namespace

Eigen::Matrix3d placeCovariance() {
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
  left_out_count_ = 0;
  for (const Place& place : places) {
    const auto known = placeAt(all_, place.T_map_base);
    if (known == all_.end() && all_.size() == kMostPlaces) {
      left_out_ = log_odds;
      ++left_out_count_;
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

double Hypotheses::refuted() const {
  double most = 0.0;
  for (const Hypothesis& hypothesis : all_) most = std::max(most, hypothesis.refuted);
  return most;
}

bool Hypotheses::lackSome(Against against) const {
  if (!left_out_) return false;
  const double all = *left_out_ + (against == Against::kTogether ? std::log(left_out_count_) : 0.0);
  return all >= bestBesidesWord() - kMargin;
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
  return placeAt(all_, T_map_base) != all_.end();
}

Hypothesis* Hypotheses::knownWithin(const Leeway& leeway) {
  const auto known = std::find_if(all_.begin(), all_.end(), [&](const Hypothesis& hypothesis) {
    return hypothesis.isKnown() && leeway.allows(hypothesis.T_map_ridden);
  });
  return known == all_.end() ? nullptr : &*known;
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
  double of_prior = 0.0;
  for (const Hypothesis& hypothesis : all_) {
    best = std::max(best, hypothesis.log_odds);
    const double prior = std::min(hypothesis.prior, odds.value());
    if (hypothesis.prior > 0.0) of_prior = std::min(of_prior, hypothesis.log_odds - prior);
  }
  return std::min(of_prior, best - malus);
}

bool Hypotheses::isByWord() const {
  return std::any_of(all_.begin(), all_.end(), [&](const Hypothesis& hypothesis) {
    return hypothesis.prior > 0.0 && hypothesis.word > 0.0 && !hypothesis.is_new;
  });
}

void Hypotheses::ride(const Pose2& motion) {
  for (Hypothesis& hypothesis : all_) hypothesis.ride(motion);
  T_map_kept_ = T_map_kept_ * motion;
}

void Hypotheses::moveKept(const Pose2& T_map_base) {
  for (Hypothesis& hypothesis : all_) {
    if (hypothesis.was_believed) hypothesis.moveTo(T_map_base);
  }
  T_map_kept_ = T_map_base;
}

void Hypotheses::note(const Pose2& T_map_core) {
  const auto place = about(all_, T_map_core);
  if (place != all_.end()) place->T_map_core = T_map_core;
}

/// A place that is spared does not rule out what explains the scan, nor one that fits badly where
/// the wheels can have slipped to.
void Hypotheses::prune(Against against) {
  std::stable_sort(all_.begin(), all_.end(), [](const Hypothesis& a, const Hypothesis& b) {
    return a.log_odds > b.log_odds;
  });
  const std::size_t first_unlikely = firstUnlikely(against);
  const bool is_disputed = std::any_of(
      all_.begin(), all_.end(), [](const Hypothesis& hypothesis) { return hypothesis.is_spared; });
  const double far_better = all_.empty() ? 0.0 : kFarBetter * all_.front().error;
  bool is_kept_out = false;
  std::vector<Hypothesis> left;  // all are there until it is complete: memory may run out
  left.reserve(all_.size());
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const Hypothesis& hypothesis = all_[i];
    const bool is_likely = i < first_unlikely;
    const bool is_slip = hypothesis.has_slipped && hypothesis.error < far_better;
    const bool is_left = is_likely || is_slip || (is_disputed && hypothesis.is_explained);
    const auto same = placeAt(left, hypothesis.T_map_base);
    if (same != left.end()) {
      same->was_believed = same->was_believed || hypothesis.was_believed;
      same->has_slipped = same->has_slipped || hypothesis.has_slipped;
    } else if (is_left) {
      left.push_back(hypothesis);
    } else if (hypothesis.was_believed) {
      is_kept_out = true;
    }
  }
  all_.swap(left);
  is_kept_ruled_out_ = is_kept_ruled_out_ || is_kept_out;
}

bool Hypotheses::isOutdone(const Pose2& T_map_core) const {
  const auto core = placeAt(all_, T_map_core);
  if (core == all_.end()) return false;
  const Hypothesis& best = all_.front();
  return best.log_odds - core->log_odds > kMargin && best.error < kFarBetter * core->error &&
         tolerated(best.error) < core->error;
}

int Hypotheses::alike(const Pose2& T_map_base) const {
  const auto count = std::count_if(all_.begin(), all_.end(), [&](const Hypothesis& hypothesis) {
    return hypothesis.is_explained && !areSamePlace(hypothesis.T_map_base, T_map_base);
  });
  return static_cast<int>(count);
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
