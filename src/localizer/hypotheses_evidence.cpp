// SPDX-License-Identifier: BSD-3-Clause
// What a scan and the other senses say of hypotheses.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kept_place.hpp"
#include "localizer/hypotheses.hpp"
#include "ser/place_refiner.hpp"

namespace adaptive_localization {
namespace {

// Places judged by each scan, where one leads, and at the most of those to be aligned with it.
constexpr std::size_t kLikeliest = 4, kInTurn = 4, kAtOnce = 40;
constexpr double kScale = 0.1 / 15.0;  // m, for 15 independent beams
constexpr double kScaleShare = 0.25;
constexpr double kRough = 0.12;  // m, above: errors are the map's, alike for all scans nearby
constexpr double kMostWithoutFit = 1.0;  // of log odds, that a scan says which fits nowhere well,
constexpr double kMostOfKept = 0.2;      // and that it says of a kept place
constexpr double kMostBesideScan = 7.0;  // that a sense says in all, where the laser sees as well

}  // namespace

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

/// Than the likeliest, to be judged by the next scan.
std::size_t Hypotheses::roomForOthers() const {
  return hasLeader() ? kInTurn : kAtOnce;
}

/// A place that the last scan did not fit may not fit the next one either.
SearchWork Hypotheses::work() const {
  constexpr SearchWork kAlignedPlace = 4000, kSlip = 12 * kAlignedPlace;
  const std::size_t judged = std::min(all_.size(), kLikeliest + roomForOthers());
  return kAlignedPlace * static_cast<SearchWork>(judged) + kSlip * slips_sought_;
}

/// Of places that are sorted, likeliest first.
std::size_t Hypotheses::firstUnlikely(Against against) const {
  const double best = bestBesidesWord(), most = std::exp(-kMargin);
  double mass = 0.0;
  std::size_t first = all_.size();
  for (; first > 0; --first) {
    const double share = std::exp(all_[first - 1].log_odds - best);
    mass = against == Against::kTogether ? mass + share : share;
    if (mass >= most) break;
  }
  return first;
}

/// Those that the scan judges; share is how much of it is new. What a search aligned with it costs
/// no more time.
void Hypotheses::choose(double share) {
  std::size_t room = roomForOthers(), likeliest = 0, added = 0;
  std::vector<Hypothesis*> others;
  for (Hypothesis& hypothesis : all_) {
    hypothesis.share = std::min(1.0, hypothesis.share + share);
    ++hypothesis.waited;
    hypothesis.is_due = hypothesis.aligned.has_value() || hypothesis.T_map_core.has_value() ||
                        hypothesis.isKnown() || (!hypothesis.is_new && likeliest++ < kLikeliest);
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

bool Hypotheses::keepsOne() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Hypothesis& hypothesis) { return hypothesis.is_kept; });
}

/// What a scan may say against a place at most. What somebody moved came into view before, little
/// by little: what came at once, and is where another place has it, speaks against a kept place as
/// against any. One thing that fills a narrow view does not rule out even a place that was believed
/// in lately. Where scans have fitted, and each since then has shown what the one before did,
/// nobody carried the robot: the map is rather wrong there.
double Hypotheses::mostLost(const PlaceRefiner& refiner, const Hypothesis& hypothesis, bool fits,
                            double usual, const News& news) const {
  constexpr double kAll = std::numeric_limits<double>::infinity();
  if (!hypothesis.is_kept) {
    return hypothesis.was_believed && refiner.view() <= kMostOfView ? kMostPerMetre : kAll;
  }
  if (fits && news.is_sudden) return kAll;
  const bool is_word = hypothesis.word > 0.0;
  const double most = mostAgainst(refiner, hypothesis.T_map_base, is_word, usual);
  return news.goes_on && !is_word ? std::min(most, kMostPerMetre) : most;
}

double Hypotheses::lostBy(const PlaceRefiner& refiner, Hypothesis& hypothesis, bool fits,
                          double usual, const News& news) const {
  double lost = loss(hypothesis.error, usual);
  const bool is_outdone = !fits && least_error_ < kFarBetter * hypothesis.error;
  if (!fits && (!is_outdone || keepsOne())) {
    lost = std::min(lost, hypothesis.is_kept ? kMostOfKept : kMostWithoutFit);
  }
  hypothesis.is_explained = lost == 0.0;
  const double most = mostLost(refiner, hypothesis, fits, usual, news);
  hypothesis.is_spared = lost > most;
  hypothesis.is_refuted = hypothesis.is_kept && (std::isinf(most) || is_outdone);
  if (std::isinf(most)) return news.share * lost;
  return std::min(news.share * lost, news.sight * most);
}

/// How much of what a scan says counts. Where even the likeliest place has lost odds, the map is
/// not as the world is, and what scans say against the others is worth less than it looks: it is
/// tempered (the learning rate of a Bayesian whose models are all wrong: Gruenwald 2012).
double Hypotheses::trustInScans() const {
  constexpr double kHalf = 6.0;  // log odds lost by the likeliest: a scan counts half
  if (all_.empty()) return 1.0;
  const auto best = std::max_element(
      all_.begin(), all_.end(),
      [](const Hypothesis& a, const Hypothesis& b) { return a.log_odds < b.log_odds; });
  return 1.0 / (1.0 + std::max(0.0, -best->log_odds) / kHalf);
}

void Hypotheses::weigh(const Observations& observations, const News& news, double usual) {
  const Scan& scan = observations.scan;
  const bool is_seen = scan.hits() > 0;
  const PlaceRefiner refiner = refinerFor(scan);
  choose(news.share);
  is_seen ? align(refiner, usual, true) : correctBySenses(observations);
  for (const Hypothesis& other : led_to_) {
    if (all_.size() >= kMostPlaces) break;
    all_.push_back(other);
    least_error_ = std::min(least_error_, other.error);
  }
  const bool fits = least_error_ <= std::max(kGoodFit, withTolerance(usual));
  const double trust = trustInScans();
  const Eigen::ArrayXXd scored = scores(observations);
  for (std::size_t i = 0; i < all_.size(); ++i) {
    Hypothesis& hypothesis = all_[i];
    if (!hypothesis.is_due) continue;
    const bool is_found = hypothesis.is_new && !hypothesis.was_believed;
    const double worth = is_found ? 1.0 : hypothesis.share;
    if (is_seen) {
      const double lost = trust * lostBy(refiner, hypothesis, fits, usual,
                                         {worth, news.sight, news.is_sudden, news.goes_on});
      hypothesis.log_odds -= lost;
      hypothesis.refuted += hypothesis.is_refuted ? lost : 0.0;
    }
    for (std::size_t k = 0; k < senses_->parts().size(); ++k) {
      const double by_sense = scored(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
      const double most = senses_->parts()[k]->mostInAll();
      hypothesis.hear(k, worth * by_sense, is_seen ? std::min(most, kMostBesideScan) : most);
    }
    hypothesis.is_new = false;
    hypothesis.waited = 0;
    hypothesis.share = 0.0;
  }
}

}  // namespace adaptive_localization
