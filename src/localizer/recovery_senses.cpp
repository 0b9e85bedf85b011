// SPDX-License-Identifier: BSD-3-Clause
// What observations tell of places, by the laser or, without one, by other senses.
#include <algorithm>
#include <utility>

#include "kept_place.hpp"
#include "localizer/recovery.hpp"
#include "occlusion.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {
namespace {

/// A laser that sends scans, and not one beam that is valid.
bool isBlind(const Scan& scan) {
  return scan.invalid > 0 && scan.hits() + scan.no_return_bearing.size() == 0;
}

}  // namespace

/// A laser that is covered, unless it sees just the wall of the map that the robot stands before.
bool Recovery::isCoveredAt(const Pose2& T_map_base, const Scan& scan) const {
  if (!isCovered(scan)) return false;
  if (scan.hits() == 0 || seesNothing(scan)) return true;
  return range_error_.at(T_map_base, scan).error > usual_.limit();
}

/// An occluded laser says nothing: then other senses are asked, as where there is no laser.
Observations Recovery::withoutCover(const Pose2& T_map_base,
                                    const Observations& observations) const {
  Observations rest = observations;
  if (isCoveredAt(T_map_base, rest.scan)) rest.scan = {};
  return rest;
}

bool Recovery::canReplaceScan(const Pose2& T_map_base, const Observations& observations) const {
  return isCoveredAt(T_map_base, observations.scan) && senses_->canLocalize(observations);
}

bool Recovery::seesAgain(const Scan& scan) const {
  return blind_ > 0 && !isCovered(scan);
}

/// Whether a scan, or another sense without one, tells where the robot is.
bool Recovery::tells(const Observations& observations) const {
  return observations.scan.hits() > 0 || senses_->canLocalize(observations);
}

/// How much of a scan that sees nothing should see a wall, of its beams; 0 of other scans.
double Recovery::shareOfWallsMissed(const Pose2& T_map_base, const Scan& scan) const {
  return seesNothing(scan) ? range_error_.at(T_map_base, scan).off_share : 0.0;
}

/// Scans contradict the place, one after another: the laser sends garbage, or the place is another
/// one. If scans fitted for some way, and each since then has shown what the one before did, nobody
/// carried the robot: the map is wrong there. If a camera's beams rather end before the map's walls
/// than go on through them, something that the map does not have may fill its view.
bool Recovery::isGarbled(const Pose2& T_map_base, const Scan& scan) const {
  if (confidence_.contradictions() < kContradictions) return false;
  if (scan.hits() == 0) return true;
  if (watch_.goesOn()) return false;
  if (scan.view.width > kMostOfView) return true;
  const RangeError::Fit fit = range_error_.at(T_map_base, scan);
  return fit.throughShare() > fit.short_share;
}

/// A view into the open is as good as any, unless the map has walls there: then the robot is
/// elsewhere. Else something is before the laser, or somebody who passes by.
void Recovery::seeNothing(const Estimate& estimate, const Observations& all) {
  constexpr int kBrief = 10;  // scans
  ground_.places->askAnew();
  const bool is_open = seesNothing(all.scan);
  const bool is_elsewhere = shareOfWallsMissed(estimate.T_map_base, all.scan) > kMissed;
  confidence_.observe(estimate, is_open ? withoutCover(estimate.T_map_base, all) : all);
  if (is_elsewhere || isBlind(all.scan)) confidence_.contradict();
  blind_ = is_elsewhere || !is_open ? blind_ + 1 : 0;
  if (blind_ > kBrief) odds_.seeNothing();
  noteLeeway(estimate);
  updateStatus();
}

/// The mean range error of a scan, or else what other senses have in its place, m.
double Recovery::errorAt(const Pose2& T_map_base, const Observations& observations) const {
  const Scan& scan = observations.scan;
  if (scan.hits() > 0) return range_error_.at(T_map_base, scan).error;
  return senses_->misfit(observations, T_map_base).value_or(RangeError::kTruncation);
}

bool Recovery::canSearch(const Observations& observations) const {
  const bool is_seen = observations.scan.hits() > 0;
  return is_seen ? ground_.places->isReadyFor(observations.scan)
                 : senses_->canLocalize(observations);
}

bool Recovery::isContradicted(const Pose2& T_map_base, const Scan& scan) const {
  if (watch_.isJustCovered()) return false;
  if (seesNothing(scan)) return shareOfWallsMissed(T_map_base, scan) > kMissed;
  if (scan.hits() == 0) return false;
  if (confidence_.fitOf(T_map_base, scan) < Confidence::kContradiction) return true;
  if (odds_.isKept() && !watch_.isAtRest()) return false;
  return range_error_.at(T_map_base, scan).error > kFarWorse * std::max(error_, usual_.limit());
}

bool Recovery::seesCarrying(const Pose2& T_odom_base, const Scan& scan) {
  watch_.observe(T_odom_base, scan);
  return watch_.sawCarrying();
}

/// All places that explain a scan, or else what other senses tell: samples of a circle, say, only
/// where no place that is followed explains it. Where a sense names no places, as sonars, or as one
/// landmark if there is such a place, the answer is those that are followed. Nothing while they are
/// being searched for.
std::optional<std::vector<Place>> Recovery::placesFor(const Observations& observations) const {
  if (observations.scan.hits() > 0) return ground_.places->search(observations);
  const std::vector<Place> followed = hypotheses_.explaining(observations, kExplained);
  std::vector<Place> places;
  for (const Pose2& pose : senses_->explanations(observations, followed.empty())) {
    places.push_back({pose, errorAt(pose, observations)});
  }
  if (places.empty() || !senses_->namesPlaces(observations)) {
    places.insert(places.end(), followed.begin(), followed.end());
  }
  std::stable_sort(places.begin(), places.end(), fitsBetter);
  return places;
}

/// Whether it is known, or will not be, where else a scan can have been taken.
bool Recovery::isAnswered(const Observations& observations) const {
  if (observations.scan.hits() == 0 || !canSearch(observations)) return true;
  return ground_.places->search(observations).has_value();
}

/// Another sense contradicts the core's place, and there is one that both scan and sense agree on.
/// If there is none, it is the sense that is wrong.
bool Recovery::isOutvoted(const Pose2& T_map_base, double error, const Observations& observations) {
  constexpr double kBetter = 1.0;  // of a log likelihood
  if (!confidence_.isContradicted() || !pace_.isOver(error)) return false;
  const auto places = placesFor(observations);
  if (!canSearch(observations) || !places) return false;
  pace_.searched(false, error);
  Particles poses(static_cast<Eigen::Index>(places->size()) + 1);
  poses.setPose(0, T_map_base);
  for (std::size_t i = 0; i < places->size(); ++i) {
    poses.setPose(static_cast<Eigen::Index>(i) + 1, (*places)[i].T_map_base);
  }
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(poses.size());
  senses_->score(observations, poses, log_likelihood);
  return log_likelihood.maxCoeff() > log_likelihood[0] + kBetter;
}

}  // namespace adaptive_localization
