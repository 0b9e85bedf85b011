// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/motion/motion_model.hpp"
#include "core/parallel.hpp"

namespace adaptive_localization {

/// Particles per chunk of a parallel loop; part of what a seed means.
constexpr std::size_t kParticlesPerChunk = 1024;

/// Calls move(i, rng) for every particle, each chunk with its own stream.
template <class Move>
void forEachParticle(const Particles& particles, Rng& rng, const Move& move) {
  const Rng streams = rng.fork();
  parallelFor(static_cast<std::size_t>(particles.size()), kParticlesPerChunk, [&](const Chunk& c) {
    Rng own = streams.split(c.index);
    for (std::size_t i = c.begin; i < c.end; ++i) move(static_cast<Eigen::Index>(i), own);
  });
}

/// Covariance of a motion over (x, y, theta) from the standard deviations of its parts, and what
/// odom_noise_* adds; jacobian of (x, y, theta) by the parts.
inline Eigen::Matrix3d noiseCovariance(const MotionOptions& options,
                                       const Eigen::Matrix3d& jacobian,
                                       const Eigen::Vector3d& sigma) {
  const Eigen::Vector3d floor(options.odom_noise_xy, options.odom_noise_xy,
                              options.odom_noise_theta);
  Eigen::Matrix3d covariance = jacobian * sigma.cwiseAbs2().asDiagonal() * jacobian.transpose();
  covariance.diagonal() += floor.cwiseAbs2();
  return covariance;
}

}  // namespace adaptive_localization
