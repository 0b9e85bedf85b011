// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/localizer.hpp"

#include <stdexcept>

#include "adaptive_localization/core/parallel.hpp"
#include "estimate_refiner.hpp"

namespace adaptive_localization {
namespace {

constexpr double kWayOfChecks = 0.5;  // m or rad, of what somebody told: the first

bool isUsable(const Particles& particles) {
  return particles.size() > 0 && particles.x.allFinite() && particles.y.allFinite() &&
         particles.theta.allFinite();
}

/// Plug-ins may answer anything.
Estimate finite(Estimate estimate) {
  if (isFinite(estimate.T_map_base)) return estimate;
  throw std::runtime_error("the filter's estimate is not a finite pose");
}

}  // namespace

Localizer::Localizer(const Parameters& parameters, Ground ground) {
  build(read(parameters), std::move(ground), std::nullopt);
}

/// Makes all that can fail before anything is replaced.
void Localizer::build(Setup setup, Ground ground, const std::optional<Prior>& belief) {
  if (!ground.places) {
    ground.places = std::make_shared<Places>(ground.map, ground.field,
                                             setup.parameters.read<EnergyGridOptions>(),
                                             setup.parameters.read<GlobalSearchOptions>());
  }
  const FilterContext context{registries_, ground, setup.parameters,
                              static_cast<std::uint64_t>(setup.options.seed)};
  auto filter = registries_.filters.make(setup.options.filter, context);
  if (belief) filter->reset(*belief);
  Confidence confidence(setup.confidence, ground.field);
  if (confidence_) confidence.goOnFrom(*confidence_);
  Rivals rivals(setup.rivals, ground.map, ground.field, ground.places);
  if (rivals_) rivals.goOnFrom(*rivals_);

  auto refiner = setup.options.refine
                     ? makeEstimateRefiner(registries_.motions, context.parameters, *ground.map)
                     : nullptr;

  setThreads(setup.options.threads);
  setup_ = std::move(setup);
  setup_.parameters = context.parameters;  // knows what the filter has read
  ground_ = std::move(ground);
  filter_ = std::move(filter);
  confidence_.emplace(confidence);
  rivals_.emplace(std::move(rivals));
  refiner_ = std::move(refiner);
}

Localizer::~Localizer() = default;

const Match* Localizer::match() const {
  const Match* own = refiner_ ? refiner_->match() : nullptr;
  return own ? own : filter_->match();
}

void Localizer::configure(const Parameters& parameters) {
  Setup setup = read(parameters);
  Ground ground = ground_;
  if (!hasSamePlaces(setup)) ground.places = nullptr;
  if (!hasSameFilter(setup) || !hasSameMatcher(setup) || !ground.places) {
    return build(std::move(setup), std::move(ground), belief());
  }
  Confidence confidence(setup.confidence, ground.field);
  confidence.goOnFrom(*confidence_);
  Rivals rivals(setup.rivals, ground.map, ground.field, ground.places);
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
  if (refiner_) refiner_->reset();
  confidence_->reset();
  converged_ = false;
  from_anywhere_ = std::holds_alternative<Anywhere>(prior);
  is_told_ = is_unverified_ = std::holds_alternative<Gaussian2>(prior);
  way_to_check_ = 0.0;
  way_of_checks_ = kWayOfChecks;
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

void Localizer::setMap(Ground ground) {
  const auto belief = beliefOn(*ground.map);
  build(setup_, std::move(ground), belief);
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

Localization Localizer::update(const Pose2& T_odom_base, const Observations& observations) {
  last_.updated = false;
  if (last_.status == Status::kUninitialised || !isFinite(T_odom_base)) return last_;
  const bool first = !T_odom_base_at_update_;
  const Pose2 motion = first ? Pose2{} : between(*T_odom_base_at_update_, T_odom_base);
  if (first || update_requested_ || gateOpens(motion, observations)) {
    updateFilter(motion, observations);
    T_odom_base_at_update_ = T_odom_base;
    last_.T_map_odom = corrected(last_.T_map_odom * T_odom_base) * inverse(T_odom_base);
    update_requested_ = false;
  } else if (is_unverified_ && ground_.places->isReadyFor(observations.scan)) {
    checkWhatWasTold(motion, observations);  // a robot that stands still need not drive on for that
    conclude();
  }
  last_.T_map_base = last_.T_map_odom * T_odom_base;
  return last_;
}

void Localizer::updateFilter(const Pose2& motion, const Observations& observations) {
  const Pose2 T_map_base_expected = last_.estimate.T_map_base * motion;
  last_.estimate = finite(filter_->update(motion, observations));
  if (refiner_ && !filter_->match())
    last_.estimate = refiner_->refine(last_.estimate, motion, observations.scan);
  confidence_->observe(last_.estimate, observations);
  rivals_->observe(motion, last_.estimate.T_map_base, observations);
  checkWhatWasTold(motion, observations);
  if (rivals_->isSettled() && isDoubtful(T_map_base_expected)) {
    rivals_->open(T_map_base_expected);
    rivals_->observe({}, last_.estimate.T_map_base, observations);
  }
  relocalize();
  conclude();
  last_.updated = true;
}

void Localizer::conclude() {
  last_.status = judge();
  converged_ = converged_ || last_.status == Status::kTracking;
  last_.modes = rivals_->modes().empty() ? last_.estimate.modes : rivals_->modes();
  last_.confidence = confidence_->value() * rivals_->shareOf(last_.estimate.T_map_base);
}

}  // namespace adaptive_localization
