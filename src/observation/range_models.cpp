// SPDX-License-Identifier: BSD-3-Clause
#include "observation/range_models.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kChunk = 64;  // particles; a ray costs much more than a look-up

/// Calls visit(bearing in base, range read, whether it is a hit) for each valid beam.
template <class Visit>
void forEachBeam(const Scan& scan, const Visit& visit) {
  for (Eigen::Index j = 0; j < scan.range.size(); ++j) {
    visit(static_cast<double>(scan.bearing[j]), static_cast<double>(scan.range[j]), true);
  }
  for (Eigen::Index j = 0; j < scan.no_return_bearing.size(); ++j) {
    visit(static_cast<double>(scan.no_return_bearing[j]), scan.max_range, false);
  }
}

template <class LogLikelihood>
void scoreEach(const Particles& particles, Eigen::Ref<Eigen::ArrayXd> sums,
               const LogLikelihood& log_likelihood) {
  parallelFor(static_cast<std::size_t>(particles.size()), kChunk, [&](const Chunk& chunk) {
    for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      sums[i] += log_likelihood(particles.pose(i));
    }
  });
}

/// Expected range of a beam for a robot at a pose.
double expected(const RayCaster& caster, const Scan& scan, const Pose2& T_map_base,
                double bearing) {
  const Eigen::Vector2d start = T_map_base * scan.position;
  return caster.range({start.x(), start.y(), T_map_base.theta + bearing}, scan.max_range);
}

}  // namespace

double BeamModel::logLikelihood(const Scan& scan, const Pose2& T_map_base) const {
  double sum = 0.0;
  forEachBeam(scan, [&](double bearing, double z, bool hit) {
    const double z_star = expected(ray_caster_, scan, T_map_base, bearing);
    const double deviations = (z - z_star) / options_.laser_sigma_hit;
    double p = options_.laser_z_hit * std::exp(-0.5 * deviations * deviations);
    if (z < z_star) {
      p += options_.laser_z_short * options_.laser_lambda_short *
           std::exp(-options_.laser_lambda_short * z);
    }
    p += hit ? options_.laser_z_rand / scan.max_range : options_.laser_z_max;
    sum += std::log(std::max(p, 1e-12));
  });
  return sum;
}

double BeamModel::score(const Observations& observations, const Particles& particles,
                        Eigen::Ref<Eigen::ArrayXd> log_likelihood) const {
  const Scan& scan = observations.scan;
  const auto beams = static_cast<double>(scan.range.size() + scan.no_return_bearing.size());
  if (scan.hits() == 0) return 0.0;
  const double independent = std::min(beams, options_.effective_beams);
  scoreEach(particles, log_likelihood,
            [&](const Pose2& pose) { return logLikelihood(scan, pose) * (independent / beams); });
  return independent;
}

double InverseL1::score(const Observations& observations, const Particles& particles,
                        Eigen::Ref<Eigen::ArrayXd> log_likelihood) const {
  const Scan& scan = observations.scan;
  if (scan.hits() == 0) return 0.0;
  scoreEach(particles, log_likelihood, [&](const Pose2& pose) {
    double error = 0.0;
    forEachBeam(scan, [&](double bearing, double z, bool) {
      error += std::abs(expected(ray_caster_, scan, pose, bearing) - z);
    });
    return -std::log(std::max(error, 1e-3));
  });
  return 1.0;
}

}  // namespace adaptive_localization
