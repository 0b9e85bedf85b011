// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/rivals.hpp"

#include <algorithm>
#include <cmath>

#include "ser/place_refiner.hpp"

namespace adaptive_localization {
namespace {

constexpr double kTruncation = 0.5;     // m; range errors beyond tell no more
constexpr double kKnownBonus = 3.0;     // most lost robots were not carried away
constexpr double kLateMalus = 3.0;      // of places that an earlier search did not find
constexpr double kExplained = 0.2;      // m, mean range error of a scan that a place explains
constexpr double kSearchWay = 1.0;      // m or rad between searches while places are left
constexpr int kLongestPause = 8;        // scans between searches that find nothing
constexpr double kStiffness = 0.2;      // m, of the odometry, against the sum over a scan's hits
constexpr double kPlaceStd = 0.05;      // m, of a place aligned with a scan
constexpr double kPlaceTurnStd = 0.03;  // rad

/// A hand before the laser looks like a corner of the map somewhere: a scan that sees hardly
/// anything beyond arm's length is no evidence.
bool isCovered(const Scan& scan) {
  constexpr double kArm = 0.6;    // m
  constexpr double kShare = 0.1;  // of the beams
  const Eigen::Index far =
      (scan.range > static_cast<float>(kArm)).count() + scan.no_return_bearing.size();
  const Eigen::Index beams = scan.range.size() + scan.no_return_bearing.size();
  return static_cast<double>(far) < kShare * static_cast<double>(beams);
}

double wayOf(const Pose2& motion) {
  return std::hypot(motion.x, motion.y) + std::abs(motion.theta);
}

Eigen::Matrix3d placeCovariance() {
  return Eigen::Vector3d(kPlaceStd * kPlaceStd, kPlaceStd * kPlaceStd,
                         kPlaceTurnStd * kPlaceTurnStd)
      .asDiagonal();
}

}  // namespace

Rivals::Rivals(const RivalsOptions& options, std::shared_ptr<const OccupancyGrid> map,
               std::shared_ptr<const DistanceField> field, std::shared_ptr<Places> places)
    : options_(options),
      map_(std::move(map)),
      field_(std::move(field)),
      places_(std::move(places)) {}

void Rivals::open(const std::optional<Pose2>& T_map_base) {
  close();
  settled_ = false;
  if (T_map_base) hypotheses_.push_back({*T_map_base, kKnownBonus, 0.0});
}

void Rivals::close() {
  settled_ = true;
  searched_ = explained_ = false;
  scans_until_search_ = pause_ = contradictions_ = 0;
  way_ = options_.rival_distance;  // the first scan counts in full
  way_since_search_ = 0.0;
  hypotheses_.clear();
  modes_.clear();
}

Verdict Rivals::judge(const Pose2& T_map_base, const Observations& observations) const {
  if (observations.scan.hits() == 0 || isCovered(observations.scan)) return Verdict::kUnknown;
  const std::vector<Place>& places = places_->search(observations);
  if (places.empty()) return Verdict::kUnknown;
  const PlaceRefiner refiner(map_, *field_, observations.scan, observations.scan.max_range,
                             kTruncation);
  Hypothesis here{T_map_base, 0.0, 0.0};
  align(refiner, here);
  const double least = std::min(here.error, places.front().error);
  if (loss(here.error, least) > options_.rival_margin + kKnownBonus) return Verdict::kWrong;
  const bool is_only_one = std::all_of(places.begin(), places.end(), [&](const Place& place) {
    return areSamePlace(place.T_map_base, T_map_base) ||
           loss(place.error, least) > options_.rival_margin;
  });
  return is_only_one ? Verdict::kRight : Verdict::kPossible;
}

void Rivals::goOnFrom(const Rivals& other) {
  settled_ = other.settled_;
  searched_ = other.searched_;
  explained_ = other.explained_;
  contradictions_ = other.contradictions_;
  least_error_ = other.least_error_;
  scans_until_search_ = other.scans_until_search_;
  pause_ = other.pause_;
  way_ = other.way_;
  way_since_search_ = other.way_since_search_;
  hypotheses_ = other.hypotheses_;
  modes_ = other.modes_;
}

double Rivals::shareOf(const Pose2& T_map_base) const {
  if (settled_) return 1.0;
  for (const Mode& mode : modes_) {
    if (areSamePlace(mode.T_map_base, T_map_base)) return mode.mass;
  }
  return 0.0;
}

void Rivals::observe(const Pose2& motion, const Pose2& T_map_base,
                     const Observations& observations) {
  for (Hypothesis& hypothesis : hypotheses_) hypothesis.T_map_base = hypothesis.T_map_base * motion;
  way_ += wayOf(motion);
  way_since_search_ += wayOf(motion);
  if (settled_ || observations.scan.hits() == 0 || isCovered(observations.scan)) return;
  const PlaceRefiner refiner(map_, *field_, observations.scan, observations.scan.max_range,
                             kTruncation);
  for (Hypothesis& hypothesis : hypotheses_) align(refiner, hypothesis);
  believe(refiner, T_map_base);
  if (searchIsDue()) search(observations);
  weigh(std::min(1.0, way_ / options_.rival_distance));
  way_ = 0.0;
  conclude(T_map_base);
}

/// Hits can be drawn to the far side of a thin wall: ranges tell.
void Rivals::align(const PlaceRefiner& refiner, Hypothesis& hypothesis) const {
  const Place place = refiner.refine(hypothesis.T_map_base, kStiffness);
  hypothesis.error = refiner.error(hypothesis.T_map_base);
  if (place.error > hypothesis.error) return;
  if (!areSamePlace(place.T_map_base, hypothesis.T_map_base)) return;
  hypothesis.T_map_base = place.T_map_base;
  hypothesis.error = place.error;
}

/// Where the filter believes to be counts as well, once something is known, whether the search
/// finds it or not.
void Rivals::believe(const PlaceRefiner& refiner, const Pose2& T_map_base) {
  if (hypotheses_.empty() || !isFinite(T_map_base) || knows(T_map_base)) return;
  Hypothesis believed{T_map_base, best() - kLateMalus, 0.0};
  align(refiner, believed);
  hypotheses_.push_back(believed);
}

bool Rivals::knows(const Pose2& T_map_base) const {
  return std::any_of(hypotheses_.begin(), hypotheses_.end(), [&](const Hypothesis& hypothesis) {
    return areSamePlace(hypothesis.T_map_base, T_map_base);
  });
}

double Rivals::best() const {
  double best = hypotheses_.empty() ? 0.0 : hypotheses_.front().log_likelihood;
  for (const auto& hypothesis : hypotheses_) best = std::max(best, hypothesis.log_likelihood);
  return best;
}

/// While no place explains the scans each may be the one that tells, but searching is not free.
bool Rivals::searchIsDue() {
  if (!searched_ || !explained_) return --scans_until_search_ < 0;
  return way_since_search_ > kSearchWay;
}

void Rivals::search(const Observations& observations) {
  const std::vector<Place>& places = places_->search(observations);
  way_since_search_ = 0.0;
  explained_ = !places.empty() && places.front().error < kExplained;
  pause_ = explained_ ? 0 : std::min(kLongestPause, 2 * pause_ + 1);
  scans_until_search_ = pause_;
  if (places.empty()) return;
  const double entry = searched_ ? best() - kLateMalus : 0.0;
  for (const Place& place : places) {
    if (!knows(place.T_map_base)) hypotheses_.push_back({place.T_map_base, entry, place.error});
  }
  searched_ = true;
}

/// Of log likelihood, by a scan that a place explains with this error and the best one with least.
double Rivals::loss(double error, double least) const {
  const double excess =
      error - (1.0 + options_.rival_tolerance_share) * least - options_.rival_tolerance;
  return options_.rival_beams * std::max(0.0, excess) / options_.rival_scale;
}

void Rivals::weigh(double share) {
  double least = kTruncation;
  for (const auto& hypothesis : hypotheses_) least = std::min(least, hypothesis.error);
  least_error_ = least;
  explained_ = least < kExplained;
  for (auto& hypothesis : hypotheses_) {
    hypothesis.log_likelihood -= (hypothesis.is_new ? 1.0 : share) * loss(hypothesis.error, least);
    hypothesis.is_new = false;
  }
}

void Rivals::conclude(const Pose2& T_map_base) {
  std::stable_sort(
      hypotheses_.begin(), hypotheses_.end(),
      [](const Hypothesis& a, const Hypothesis& b) { return a.log_likelihood > b.log_likelihood; });
  const double limit = best() - options_.rival_margin;
  std::vector<Hypothesis> kept;
  for (const Hypothesis& hypothesis : hypotheses_) {
    const auto isSame = [&](const Hypothesis& other) {
      return areSamePlace(hypothesis.T_map_base, other.T_map_base);
    };
    if (hypothesis.log_likelihood >= limit && std::none_of(kept.begin(), kept.end(), isSame)) {
      kept.push_back(hypothesis);
    }
  }
  hypotheses_ = std::move(kept);
  modes_.clear();
  double sum = 0.0;
  for (const auto& hypothesis : hypotheses_) {
    modes_.push_back({hypothesis.T_map_base, placeCovariance(),
                      std::exp(hypothesis.log_likelihood - hypotheses_.front().log_likelihood)});
    sum += modes_.back().mass;
  }
  for (Mode& mode : modes_) mode.mass /= sum;
  settled_ = searched_ && modes_.size() == 1 && areSamePlace(modes_[0].T_map_base, T_map_base);
  contradictions_ = explained_ && !knows(T_map_base) ? contradictions_ + 1 : 0;
  if (settled_) close();
}

}  // namespace adaptive_localization
