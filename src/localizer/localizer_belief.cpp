// SPDX-License-Identifier: BSD-3-Clause
// What a localizer believes: from a prior on, to another filter or map, and to other places.
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "estimate_refiner.hpp"
#include "localizer/recovery.hpp"

namespace adaptive_localization {
namespace {

bool isUsable(const Gaussian2& gaussian) {
  return isPlace(gaussian.mean) && gaussian.covariance.allFinite() &&
         gaussian.covariance.cwiseAbs().maxCoeff() <= kVariance.high;
}

bool isUsable(const Particles& particles) {
  return particles.size() > 0 && particles.x.allFinite() && particles.y.allFinite() &&
         particles.theta.allFinite();
}

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

}  // namespace

void Localizer::reset(const Prior& prior) {
  const auto* gaussian = std::get_if<Gaussian2>(&prior);
  if (gaussian && !isUsable(*gaussian)) {
    const Pose2& mean = gaussian->mean;
    std::ostringstream message;
    message << "initial pose: got (" << mean.x << ", " << mean.y << ") m, " << mean.theta
            << " rad with variances " << gaussian->covariance.diagonal().transpose()
            << ", expected numbers within " << kFarthest << " m and variances up to "
            << kVariance.high;
    throw std::invalid_argument(message.str());
  }
  const auto* cloud = std::get_if<Particles>(&prior);
  if (cloud && !isUsable(*cloud)) {
    throw std::invalid_argument("initial particles: got " + std::to_string(cloud->size()) +
                                ", expected at least one, and finite numbers");
  }
  filter_->reset(prior);
  if (refiner_) refiner_->reset();
  match_.reset();
  recovery_->reset(prior);
  is_anywhere_ = std::holds_alternative<Anywhere>(prior);
  if (!is_anywhere_) compass_.reset();  // what was learned elsewhere may be wrong
  gyroscope_.restart();
  sonars_.forget();
  T_odom_base_at_update_.reset();
  last_ = {};
  last_.status = Status::kGlobalizing;
  last_.estimate = filter_->estimate();
  last_.T_map_base = last_.estimate.T_map_base;
  last_.covariance = last_.estimate.covariance;
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
  if (free.empty() && is_anywhere_) return Anywhere{};
  if (free.empty()) return Gaussian2{last_.estimate.T_map_base, last_.estimate.covariance};
  Particles kept(static_cast<Eigen::Index>(free.size()));
  for (Eigen::Index k = 0; k < kept.size(); ++k) {
    const Eigen::Index i = free[static_cast<std::size_t>(k)];
    kept.setPose(k, particles->pose(i));
    kept.log_weight[k] = particles->log_weight[i];
  }
  return kept;
}

/// To the places that are left.
void Localizer::moveBelief() {
  constexpr Eigen::Index kParticles = 2000;
  Rng rng = Rng(static_cast<std::uint64_t>(setup_.options.seed)).split(++moves_);
  filter_->reset(Prior(drawFrom(recovery_->modes(), kParticles, rng)));
  last_.estimate = filter_->estimate();
}

}  // namespace adaptive_localization
