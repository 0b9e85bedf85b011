// SPDX-License-Identifier: BSD-3-Clause
#include "particle_filter.hpp"

#include <cmath>

#include "adaptive_localization/particle/summary.hpp"
#include "core/parts.hpp"
#include "particle/gaussian_cloud.hpp"

namespace adaptive_localization {
namespace {

/// Mean distance of particles from their mean, m.
double spreadOf(const Particles& particles, const Eigen::ArrayXd& weights) {
  const double x = (weights * particles.x).sum();
  const double y = (weights * particles.y).sum();
  return sumOverParts<double>(particles.size(), [&](Eigen::Index first, Eigen::Index size) {
    const auto dx = particles.x.segment(first, size) - x;
    const auto dy = particles.y.segment(first, size) - y;
    return (weights.segment(first, size) * (dx.square() + dy.square()).sqrt()).sum();
  });
}

bool isOnePlace(const Estimate& estimate) {
  constexpr double kStandardDeviation = 0.5;  // m
  return estimate.modes.front().mass > 0.9 && estimate.covariance.topLeftCorner<2, 2>().trace() <
                                                  kStandardDeviation * kStandardDeviation;
}

}  // namespace

void ParticleFilter::reset(const Prior& prior) {
  const auto* cloud = std::get_if<Particles>(&prior);
  taken_over_ = cloud && cloud->size() > 0;
  anywhere_ = false;
  pending_.finish();
  if (taken_over_) {
    particles_ = *cloud;
    particles_.log_weight = normalisedWeights(cloud->log_weight).log();
  } else if (const auto* gaussian = std::get_if<Gaussian2>(&prior)) {
    particles_ = drawCloud(*gaussian, parts_.size->initial(), rng_);
  } else {
    anywhere_ = true;
    parts_.elsewhere->condition(Observations{});  // forgets what was seen before
    drawElsewhere(parts_.size->initial());
  }
  parts_.size->observe(particles_);  // else the size would be that of the belief before
  parts_.exploration->reset();
  updates_since_resampling_ = 0;
}

void ParticleFilter::drawElsewhere(Eigen::Index count) {
  particles_ = Particles(count);
  for (Eigen::Index i = 0; i < particles_.size(); ++i) {
    particles_.setPose(i, parts_.elsewhere->draw(rng_));
  }
}

Estimate ParticleFilter::update(const Pose2& motion, const Observations& observations) {
  if (anywhere_ && parts_.elsewhere->condition(observations)) {
    drawElsewhere(parts_.size->initial(*parts_.elsewhere, rng_));
    parts_.size->observe(particles_);
    anywhere_ = false;
  } else {
    move(pending_.rest(motion));
  }
  pending_.move(motion);
  const Eigen::ArrayXd weights = weigh(observations);
  particles_.log_weight = logOf(weights);
  Estimate estimate = summarize(particles_, weights);

  if (isOnePlace(estimate)) anywhere_ = false;

  const double elsewhere = parts_.exploration->share();
  if (elsewhere > 0.0) parts_.elsewhere->condition(observations);  // this may be slow
  if (resamplingIsDue(weights, elsewhere)) {
    resample(weights, elsewhere);
    estimate.share_elsewhere = elsewhere;
  }
  pending_.finish();
  return estimate;
}

void ParticleFilter::move(const Pose2& motion) {
  if (isPlausible(motion)) parts_.motion->propagate(motion, particles_, rng_);
}

Estimate ParticleFilter::estimate() const {
  return summarize(particles_, normalisedWeights(particles_.log_weight));
}

Eigen::ArrayXd ParticleFilter::weigh(const Observations& observations) {
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(particles_.size());
  const Eigen::ArrayXd weights = normalisedWeights(particles_.log_weight);
  const double beams = parts_.observation->score(observations, particles_, log_likelihood);
  if (beams <= 0.0) return weights;
  Eigen::Index best = 0;
  log_likelihood.maxCoeff(&best);
  const double likelihood =
      sumOverParts<double>(particles_.size(), [&](Eigen::Index first, Eigen::Index size) {
        return (weights.segment(first, size) * (log_likelihood.segment(first, size) / beams).exp())
            .sum();
      });
  const Evidence evidence{observations, likelihood, particles_.pose(best),
                          spreadOf(particles_, weights), particles_.size()};
  parts_.exploration->observe(evidence);
  return temperedWeights(weights, log_likelihood, options_.min_effective_share);
}

bool ParticleFilter::resamplingIsDue(const Eigen::ArrayXd& weights, double elsewhere) {
  if (taken_over_) return true;  // so that there are as many as this filter wants
  if (++updates_since_resampling_ < options_.resample_interval) return false;
  const auto count = static_cast<double>(weights.size());
  if (!options_.selective_resampling || elsewhere * count >= 1.0) return true;
  return effectiveSize(weights) < 0.5 * count;
}

void ParticleFilter::resample(const Eigen::ArrayXd& weights, double elsewhere) {
  const Eigen::Index count =
      parts_.size->next({particles_, weights, *parts_.elsewhere, elsewhere}, rng_);
  const auto away = static_cast<Eigen::Index>(std::floor(elsewhere * static_cast<double>(count)));
  Particles next = select(particles_, parts_.resampling(weights, count - away, rng_));
  const Eigen::Index stay = next.size();
  next.x.conservativeResize(count);
  next.y.conservativeResize(count);
  next.theta.conservativeResize(count);
  for (Eigen::Index i = stay; i < count; ++i) next.setPose(i, parts_.elsewhere->draw(rng_));
  next.log_weight = Eigen::ArrayXd::Constant(count, -std::log(static_cast<double>(count)));
  particles_ = std::move(next);
  parts_.size->observe(particles_);
  if (away > 0) parts_.exploration->explored();
  updates_since_resampling_ = 0;
  taken_over_ = false;
}

}  // namespace adaptive_localization
