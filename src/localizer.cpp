// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer.hpp"

#include <cmath>
#include <stdexcept>

#include "adaptive_localization/parallel.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLostFit = 0.2;   // below: the scan contradicts the map
constexpr double kFoundFit = 0.5;  // above: it confirms it

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
                     std::shared_ptr<const DistanceField> distance_field) {
  build(read(parameters), std::move(map), std::move(distance_field), std::nullopt);
}

/// Makes all that can fail before anything is replaced.
void Localizer::build(Setup setup, std::shared_ptr<const OccupancyGrid> map,
                      std::shared_ptr<const DistanceField> distance_field,
                      const std::optional<Prior>& belief) {
  if (!distance_field) distance_field = std::make_shared<const DistanceField>(*map);
  const FilterContext context{map, distance_field, setup.parameters,
                              static_cast<std::uint64_t>(setup.options.seed)};
  auto filter = registry_.find(setup.options.filter).make(context);
  if (belief) filter->reset(*belief);
  Confidence confidence(setup.confidence, distance_field);
  if (confidence_) confidence.goOnFrom(*confidence_);

  setThreads(setup.options.threads);
  setup_ = std::move(setup);
  setup_.parameters = context.parameters;  // knows what the filter has read
  map_ = std::move(map);
  distance_field_ = std::move(distance_field);
  filter_ = std::move(filter);
  confidence_.emplace(confidence);
}

void Localizer::configure(const Parameters& parameters) {
  Setup setup = read(parameters);
  if (!hasSameFilter(setup)) return build(std::move(setup), map_, distance_field_, belief());
  Confidence confidence(setup.confidence, distance_field_);
  confidence.goOnFrom(*confidence_);
  confidence_.emplace(confidence);
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
  T_odom_base_at_update_.reset();
  last_ = {};
  last_.status = Status::kGlobalizing;
  last_.estimate = filter_->estimate();
  last_.T_map_base = last_.estimate.T_map_base;
}

void Localizer::setMap(std::shared_ptr<const OccupancyGrid> map,
                       std::shared_ptr<const DistanceField> distance_field) {
  const auto belief = beliefOn(*map);
  build(setup_, std::move(map), std::move(distance_field), belief);
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

bool Localizer::gateOpens(const Pose2& motion) const {
  return std::hypot(motion.x, motion.y) >= setup_.options.update_min_d ||
         std::abs(motion.theta) >= setup_.options.update_min_a;
}

Localization Localizer::update(const Pose2& T_odom_base, const Observations& observations) {
  last_.updated = false;
  if (last_.status == Status::kUninitialised || !isFinite(T_odom_base)) return last_;
  const bool first = !T_odom_base_at_update_;
  const Pose2 motion = first ? Pose2{} : between(*T_odom_base_at_update_, T_odom_base);
  if (first || update_requested_ || gateOpens(motion)) {
    updateFilter(motion, observations);
    T_odom_base_at_update_ = T_odom_base;
    last_.T_map_odom = last_.estimate.T_map_base * inverse(T_odom_base);
    update_requested_ = false;
  }
  last_.T_map_base = last_.T_map_odom * T_odom_base;
  return last_;
}

void Localizer::updateFilter(const Pose2& motion, const Observations& observations) {
  last_.estimate = filter_->update(motion, observations);
  confidence_->observe(last_.estimate, observations);
  last_.confidence = confidence_->value();
  last_.status = judge();
  converged_ = converged_ || last_.status == Status::kTracking;
  last_.updated = true;
}

Status Localizer::judge() const {
  const bool was_lost = last_.status == Status::kLost || !converged_;
  const bool fits = confidence_->fit() >= (was_lost ? kFoundFit : kLostFit);
  if (confidence_->isCompact() && confidence_->isAmbiguous()) return Status::kAmbiguous;
  if (confidence_->isCompact() && fits) return Status::kTracking;
  return from_anywhere_ && !converged_ ? Status::kGlobalizing : Status::kLost;
}

}  // namespace adaptive_localization
