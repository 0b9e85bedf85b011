// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/localizer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/parallel.hpp"
#include "estimate_refiner.hpp"
#include "localizer/recovery.hpp"
#include "occlusion.hpp"
#include "prepared_map.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {
namespace {

/// What a core of 3 GHz searches in so much time.
SearchWork workIn(double milliseconds) {
  constexpr double kPosesPerMillisecond = 40000.0;
  return static_cast<SearchWork>(std::min(1e15, milliseconds * kPosesPerMillisecond));
}

/// What may be searched in an update, beside what it takes to compare places.
SearchWork workFor(const LocalizerOptions& options, SearchWork comparing) {
  constexpr SearchWork kLeastShare = 5;  // one of so many
  if (options.update_budget <= 0.0) return kUnlimitedWork;
  const SearchWork all = workIn(options.update_budget);
  return std::max(all - comparing, all / kLeastShare);
}

/// Plug-ins may answer anything.
Estimate checked(Estimate estimate) {
  const Pose2& pose = estimate.T_map_base;
  if (!isFinite(pose) || !estimate.covariance.allFinite()) {
    throw std::runtime_error("the filter's estimate is not a finite pose and covariance");
  }
  if (estimate.modes.empty()) estimate.modes.push_back({pose, estimate.covariance, 1.0});
  return estimate;
}

/// Of an estimate, about another pose than its own: it is farther off by all that is between them.
Eigen::Matrix3d covarianceAbout(const Pose2& T_map_base, const Estimate& estimate) {
  const Pose2& mean = estimate.T_map_base;
  const Eigen::Vector3d off(mean.x - T_map_base.x, mean.y - T_map_base.y,
                            wrapAngle(mean.theta - T_map_base.theta));
  return estimate.covariance + off * off.transpose();
}

}  // namespace

Localizer::Localizer(const Parameters& parameters, Ground ground) {
  build(reader_.read(parameters), std::move(ground), std::nullopt);
}

void Localizer::build(Setup setup, Ground ground, const std::optional<Prior>& belief) {
  PreparedMap prepared(std::make_shared<const SetupReader>(reader_), std::move(setup),
                       std::move(ground));
  use(prepared, belief);
}

/// Makes all that can fail before anything is replaced.
void Localizer::use(PreparedMap& prepared, const std::optional<Prior>& belief) {
  if (belief) prepared.filter->reset(*belief);
  auto recovery =
      std::make_unique<Recovery>(prepared.setup.confidence, prepared.ground, prepared.senses);
  if (recovery_) recovery->copyStateOf(*recovery_);

  setThreads(prepared.setup.options.threads);
  compass_.configure(prepared.setup.compass);
  setup_ = std::move(prepared.setup);
  ground_ = std::move(prepared.ground);
  filter_ = std::move(prepared.filter);
  refiner_ = std::move(prepared.refiner);
  used_reader_ = std::move(prepared.reader);
  match_.reset();
  recovery_ = std::move(recovery);
}

Localizer::~Localizer() = default;

const Confidence& Localizer::confidence() const {
  return recovery_->fit();
}

void Localizer::configure(const Parameters& parameters) {
  Setup setup = reader_.read(parameters);
  Ground ground = ground_;
  if (!reader_.haveSamePlaces(setup, setup_)) ground.places = nullptr;
  if (!reader_.haveSameFilter(setup, setup_) || !reader_.haveSameMatcher(setup, setup_) ||
      !ground.places) {
    return build(std::move(setup), std::move(ground), belief());
  }
  auto recovery = std::make_unique<Recovery>(setup.confidence, ground, recovery_->senses());
  recovery->copyStateOf(*recovery_);
  recovery_ = std::move(recovery);
  setThreads(setup.options.threads);
  compass_.configure(setup.compass);
  setup_ = std::move(setup);
}

void Localizer::setMap(Ground ground) {
  const auto belief = beliefOn(*ground.map);
  build(setup_, std::move(ground), belief);
  requestUpdate();
}

std::function<std::shared_ptr<PreparedMap>(Ground)> Localizer::preparer() const {
  return [reader = std::make_shared<const SetupReader>(reader_), setup = setup_](Ground ground) {
    return std::make_shared<PreparedMap>(reader, setup, std::move(ground));
  };
}

void Localizer::setMap(PreparedMap& prepared) {
  use(prepared, beliefOn(*prepared.ground.map));
  requestUpdate();
}

Localization Localizer::update(const Pose2& T_odom_base, const Observations& observations) {
  last_.updated = false;
  if (last_.status == Status::kUninitialised || !isPlace(T_odom_base)) return last_;
  interval_ = std::max(0.0, observations.stamp - stamp_);  // 0 if one is no number
  stamp_ = observations.stamp;
  const bool first = !T_odom_base_at_update_;
  const Pose2 by_wheels = first ? Pose2{} : between(*T_odom_base_at_update_, T_odom_base);
  const bool is_new = first || recovery_->isUnverified(observations);  // also once there is a grid
  const bool is_done_between = std::exchange(is_searched_on_, false);
  const SearchWork work = is_done_between ? 0 : workFor(setup_.options, recovery_->work());
  ground_.places->beginUpdate(T_odom_base, is_new ? kUnlimitedWork : work);
  gyroscope_.observe(T_odom_base, observations);
  sonars_.hear(T_odom_base, observations);
  const bool is_carried = recovery_->seesCarrying(T_odom_base, observations.scan);
  if (first || update_requested_ || is_carried || gateOpens(by_wheels, observations)) {
    Gyroscope gyroscope = gyroscope_;  // as it was, should the core throw
    const Pose2 slip = gyroscope.slipDuring(by_wheels);
    updateBelief(by_wheels * slip, T_odom_base, observations);
    gyroscope_ = gyroscope;
    sonars_.forget();
    const Pose2& T_map_core = last_.estimate.T_map_base;
    const Pose2 by_odometry = first ? T_map_core : last_.T_map_odom * T_odom_base * slip;
    const Pose2 T_map_base =
        setup_.options.recovery ? recovery_->published(by_odometry, last_.estimate) : T_map_core;
    last_.T_map_odom = T_map_base * inverse(T_odom_base);
    assess(T_map_base);
    update_requested_ = false;
  } else if (recovery_->isUnverified(observations)) {  // even where the robot stands still
    recovery_->verify(last_.estimate, forCores(T_odom_base, observations));
    assess(last_.T_map_odom * *T_odom_base_at_update_);
  }
  last_.T_map_base = last_.T_map_odom * T_odom_base;
  return last_;
}

/// A doubt about a known place can wait: the scans that come meanwhile tell of it as well.
void Localizer::searchOn() {
  constexpr double kLongest = 0.2;  // s
  if (last_.status != Status::kLost && last_.status != Status::kGlobalizing) return;
  const double share = setup_.options.search_share * std::min(kLongest, interval_);
  ground_.places->searchOn(workIn(1000.0 * share));
  is_searched_on_ = share > 0.0;
}

/// A scan that contradicts the map opens it too: a robot that was carried away stands still.
bool Localizer::gateOpens(const Pose2& motion, const Observations& observations) const {
  if (std::hypot(motion.x, motion.y) >= setup_.options.update_min_d) return true;
  if (std::abs(motion.theta) >= setup_.options.update_min_a) return true;
  if (recovery_->seesAgain(observations.scan)) return true;
  return recovery_->isContradicted(last_.estimate.T_map_base * motion, observations.scan);
}

/// Cores and Recovery know one frame, the map's, and sonars that all have been heard.
Observations Localizer::forCores(const Pose2& T_odom_base, Observations observations) const {
  observations.heading = compass_.inMap(observations.heading);
  observations.sonar = sonars_.readingsFrom(T_odom_base);
  return observations;
}

/// Once the core has moved, the motion is done with, even if memory runs out thereafter.
void Localizer::updateBelief(const Pose2& motion, const Pose2& T_odom_base,
                             const Observations& observations) {
  const Pose2 T_map_base_expected = last_.estimate.T_map_base * motion;
  const Observations on_map = forCores(T_odom_base, observations);
  const Observations seen = evidenceOf(T_map_base_expected, on_map);
  last_.estimate = checked(filter_->update(motion, seen));
  if (!T_odom_base_at_update_) {
    last_.T_map_odom = last_.estimate.T_map_base * inverse(T_odom_base);
  }
  T_odom_base_at_update_ = T_odom_base;
  recovery_->ride(motion);
  refine(motion, seen, on_map.scan);
  recovery_->observe(motion, T_map_base_expected, last_.estimate, on_map);
  if (observations.heading && recovery_->knowsByScans()) {
    compass_.compare(*observations.heading, last_.estimate.T_map_base.theta,
                     last_.estimate.covariance(2, 2), wayOf(motion));
  }
  if (setup_.options.recovery && recovery_->mustMove()) moveBelief();
  last_.updated = true;
}

/// What a core is given. Where the localizer recovers, what stands before the laser is kept from
/// the core, and from any core an occluded laser where other senses tell.
Observations Localizer::evidenceOf(const Pose2& T_map_base,
                                   const Observations& observations) const {
  Observations seen = observations;
  if (setup_.options.recovery) {
    seen.scan = recovery_->evidenceOf(T_map_base, seen.scan);
  } else if (recovery_->canReplaceScan(T_map_base, observations)) {
    seen.scan = {};
  }
  return seen;
}

/// The core's estimate, by a match of what it saw.
void Localizer::refine(const Pose2& motion, const Observations& seen, const Scan& whole) {
  match_.reset();
  const bool is_refined = refiner_ && !filter_->match();
  if (is_refined) last_.estimate = refiner_->refine(last_.estimate, motion, seen);
  const Match* match = is_refined ? refiner_->match() : filter_->match();
  if (match) match_ = ofWholeScan(*match, seen.scan, whole);
}

/// About the pose that is published as of the last update.
void Localizer::assess(const Pose2& T_map_base) {
  last_.covariance = covarianceAbout(T_map_base, last_.estimate);
  last_.status = recovery_->status();
  is_anywhere_ = is_anywhere_ && last_.status != Status::kTracking;
  last_.modes = recovery_->modes().empty() ? last_.estimate.modes : recovery_->modes();
  last_.confidence = recovery_->confidence(T_map_base, last_.estimate.T_map_base);
}

}  // namespace adaptive_localization
