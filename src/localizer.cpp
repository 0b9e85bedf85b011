// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer.hpp"

#include <cmath>
#include <stdexcept>

#include "adaptive_localization/parallel.hpp"
#include "adaptive_localization/rng.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLostFit = 0.2;   // below: the scan contradicts the map
constexpr double kFoundFit = 0.5;  // above: it confirms it
constexpr int kLostScans = 2;      // contradictions in a row that raise doubts

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

bool isUsable(const Particles& particles) {
  return particles.size() > 0 && particles.x.allFinite() && particles.y.allFinite() &&
         particles.theta.allFinite();
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

Localizer::Localizer(const Parameters& parameters, std::shared_ptr<const OccupancyGrid> map,
                     std::shared_ptr<const DistanceField> distance_field,
                     std::shared_ptr<Places> places) {
  build(read(parameters), {std::move(map), std::move(distance_field), std::move(places)},
        std::nullopt);
}

/// Makes all that can fail before anything is replaced.
void Localizer::build(Setup setup, Ground ground, const std::optional<Prior>& belief) {
  if (!ground.distance_field) {
    ground.distance_field = std::make_shared<const DistanceField>(*ground.map);
  }
  if (!ground.places) {
    ground.places = std::make_shared<Places>(ground.map, ground.distance_field,
                                             setup.parameters.read<EnergyGridOptions>(),
                                             setup.parameters.read<GlobalSearchOptions>());
  }
  const FilterContext context{ground.map, ground.distance_field, setup.parameters,
                              static_cast<std::uint64_t>(setup.options.seed), ground.places};
  auto filter = registry_.find(setup.options.filter).make(context);
  if (belief) filter->reset(*belief);
  Confidence confidence(setup.confidence, ground.distance_field);
  if (confidence_) confidence.goOnFrom(*confidence_);
  Rivals rivals(setup.rivals, ground.map, ground.distance_field, ground.places);
  if (rivals_) rivals.goOnFrom(*rivals_);

  setThreads(setup.options.threads);
  setup_ = std::move(setup);
  setup_.parameters = context.parameters;  // knows what the filter has read
  ground_ = std::move(ground);
  filter_ = std::move(filter);
  confidence_.emplace(confidence);
  rivals_.emplace(std::move(rivals));
}

void Localizer::configure(const Parameters& parameters) {
  Setup setup = read(parameters);
  Ground ground = ground_;
  if (!hasSamePlaces(setup)) ground.places = nullptr;
  if (!hasSameFilter(setup) || !ground.places) {
    return build(std::move(setup), std::move(ground), belief());
  }
  Confidence confidence(setup.confidence, ground.distance_field);
  confidence.goOnFrom(*confidence_);
  Rivals rivals(setup.rivals, ground.map, ground.distance_field, ground.places);
  rivals.goOnFrom(*rivals_);
  confidence_.emplace(confidence);
  rivals_.emplace(std::move(rivals));
  setThreads(setup.options.threads);
  setup_ = std::move(setup);
}

void Localizer::reset(const Prior& prior) {
  const auto* gaussian = std::get_if<Gaussian2>(&prior);
  if (gaussian && !(isFinite(gaussian->mean) && gaussian->covariance.allFinite())) {
    throw std::invalid_argument("initial pose: got a number that is not finite");
  }
  const auto* cloud = std::get_if<Particles>(&prior);
  if (cloud && !isUsable(*cloud)) {
    throw std::invalid_argument("initial particles: got " + std::to_string(cloud->size()) +
                                ", expected at least one, and finite numbers");
  }
  filter_->reset(prior);
  confidence_->reset();
  converged_ = false;
  from_anywhere_ = std::holds_alternative<Anywhere>(prior);
  if (from_anywhere_) {
    rivals_->open();
  } else {
    rivals_->close();
  }
  T_odom_base_at_update_.reset();
  last_ = {};
  last_.status = Status::kGlobalizing;
  last_.estimate = filter_->estimate();
  last_.T_map_base = last_.estimate.T_map_base;
}

void Localizer::setMap(std::shared_ptr<const OccupancyGrid> map,
                       std::shared_ptr<const DistanceField> distance_field,
                       std::shared_ptr<Places> places) {
  const auto belief = beliefOn(*map);
  build(setup_, {std::move(map), std::move(distance_field), std::move(places)}, belief);
  requestUpdate();
}

/// As of the last update: odometry since then is applied by the next one. None before reset().
std::optional<Prior> Localizer::belief() const {
  if (last_.status == Status::kUninitialised) return std::nullopt;
  const Particles& particles = filter_->hypotheses();
  if (isUsable(particles)) return particles;
  return Gaussian2{last_.estimate.T_map_base, last_.estimate.covariance};
}

std::optional<Prior> Localizer::beliefOn(const OccupancyGrid& map) const {
  const std::optional<Prior> all = belief();
  const auto* particles = all ? std::get_if<Particles>(&*all) : nullptr;
  if (!particles) return all;
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < particles->size(); ++i) {
    if (map.isFree(map.lattice().cellAt({particles->x[i], particles->y[i]}))) free.push_back(i);
  }
  if (free.empty() && from_anywhere_ && !converged_) return Anywhere{};
  if (free.empty()) return Gaussian2{last_.estimate.T_map_base, last_.estimate.covariance};
  Particles kept(static_cast<Eigen::Index>(free.size()));
  for (Eigen::Index k = 0; k < kept.size(); ++k) {
    const Eigen::Index i = free[static_cast<std::size_t>(k)];
    kept.setPose(k, particles->pose(i));
    kept.log_weight[k] = particles->log_weight[i];
  }
  return kept;
}

/// A scan that contradicts the map opens it too: a robot that was carried away stands still.
bool Localizer::gateOpens(const Pose2& motion, const Observations& observations) const {
  if (std::hypot(motion.x, motion.y) >= setup_.options.update_min_d) return true;
  if (std::abs(motion.theta) >= setup_.options.update_min_a) return true;
  return observations.scan.hits() > 0 &&
         confidence_->fitOf(last_.estimate.T_map_base * motion, observations.scan) < kLostFit;
}

Localization Localizer::update(const Pose2& T_odom_base, const Observations& observations) {
  last_.updated = false;
  if (last_.status == Status::kUninitialised || !isFinite(T_odom_base)) return last_;
  const bool first = !T_odom_base_at_update_;
  const Pose2 motion = first ? Pose2{} : between(*T_odom_base_at_update_, T_odom_base);
  if (first || update_requested_ || gateOpens(motion, observations)) {
    updateFilter(motion, observations);
    T_odom_base_at_update_ = T_odom_base;
    if (isCorrection(last_.T_map_odom * T_odom_base)) {
      last_.T_map_odom = last_.estimate.T_map_base * inverse(T_odom_base);
    }
    update_requested_ = false;
  }
  last_.T_map_base = last_.T_map_odom * T_odom_base;
  return last_;
}

/// A robot that was known to be somewhere is there until that place is ruled out and another one,
/// that explains the scan well, is likelier than all others: what a filter makes of a blocked laser
/// is no reason to jump.
bool Localizer::isCorrection(const Pose2& T_map_base_by_odometry) const {
  constexpr double kSmall = 0.1;      // m, rad
  constexpr double kRuledOut = 0.05;  // mass
  constexpr double kLikely = 0.5;     // mass
  constexpr double kWell = 0.1;       // m
  if (!converged_ || last_.status == Status::kTracking) return true;
  if (last_.status != Status::kAmbiguous) return false;
  const Pose2 moved = between(T_map_base_by_odometry, last_.estimate.T_map_base);
  if (std::hypot(moved.x, moved.y) < kSmall && std::abs(moved.theta) < kSmall) return true;
  return rivals_->leastError() < kWell && rivals_->shareOf(T_map_base_by_odometry) < kRuledOut &&
         rivals_->shareOf(last_.estimate.T_map_base) > kLikely;
}

void Localizer::updateFilter(const Pose2& motion, const Observations& observations) {
  const Pose2 T_map_base_expected = last_.estimate.T_map_base * motion;
  last_.estimate = filter_->update(motion, observations);
  confidence_->observe(last_.estimate, observations);
  rivals_->observe(motion, last_.estimate.T_map_base, observations);
  if (rivals_->isSettled() && isDoubtful(T_map_base_expected)) {
    rivals_->open(T_map_base_expected);
    rivals_->observe({}, last_.estimate.T_map_base, observations);
  }
  if (setup_.options.relocalize && rivals_->contradictions() >= kLostScans) relocalize();
  last_.status = judge();
  converged_ = converged_ || last_.status == Status::kTracking;
  last_.modes = rivals_->modes().empty() ? last_.estimate.modes : rivals_->modes();
  last_.confidence = confidence_->value() * rivals_->shareOf(last_.estimate.T_map_base);
  last_.updated = true;
}

/// Moves the filter to the places that are left.
void Localizer::relocalize() {
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

Status Localizer::judge() const {
  if (!rivals_->isSettled()) {
    const bool fits = confidence_->latestFit() >= kFoundFit;
    if (fits && rivals_->modes().size() > 1) return Status::kAmbiguous;
    return from_anywhere_ && !converged_ ? Status::kGlobalizing : Status::kLost;
  }
  const bool was_lost = last_.status == Status::kLost || !converged_;
  const double fit = was_lost ? confidence_->latestFit() : confidence_->fit();
  const bool fits = fit >= (was_lost ? kFoundFit : kLostFit);
  if (confidence_->isCompact() && confidence_->isAmbiguous()) return Status::kAmbiguous;
  if (confidence_->isCompact() && fits) return Status::kTracking;
  return from_anywhere_ && !converged_ ? Status::kGlobalizing : Status::kLost;
}

}  // namespace adaptive_localization
