// SPDX-License-Identifier: BSD-3-Clause
#include "motion/differential_drive.hpp"

#include <cmath>

#include "noise.hpp"

namespace adaptive_localization {
namespace {

/// Below this a direction of travel is no sign of a rotation: rot1 and rot2 still add up to the
/// motion, but the noise is that of the turn as a whole.
constexpr double kStandstill = 0.01;  // m

}  // namespace

struct DifferentialDrive::Step {
  double rot1, trans, rot2;                    // rad, m, rad
  double sigma_rot1, sigma_trans, sigma_rot2;  // standard deviations
};

DifferentialDrive::Step DifferentialDrive::split(const Pose2& motion) const {
  Step step{};
  step.trans = std::hypot(motion.x, motion.y);
  if (step.trans > 0.0) step.rot1 = std::atan2(motion.y, motion.x);
  if (std::abs(step.rot1) > kPi / 2) {  // backwards
    step.rot1 = wrapAngle(step.rot1 + kPi);
    step.trans = -step.trans;
  }
  step.rot2 = wrapAngle(motion.theta - step.rot1);

  const bool corrected = rule_ == NoiseRule::kVariances;
  const auto sigma = [&](double variance) { return corrected ? std::sqrt(variance) : variance; };
  const auto square = [](double value) { return value * value; };
  const double trans2 = square(step.trans);
  // a turn by pi tells no more of the noise than standing still (amcl's rule)
  const auto folded = [](double angle) {
    return std::min(std::abs(angle), std::abs(wrapAngle(angle - kPi)));
  };
  const bool stands = std::abs(step.trans) < kStandstill;
  const double rot1_2 = stands ? 0.0 : square(folded(step.rot1));
  const double rot2_2 = square(folded(stands ? motion.theta : step.rot2));
  step.sigma_rot1 = sigma(options_.odom_alpha1 * rot1_2 + options_.odom_alpha2 * trans2);
  step.sigma_rot2 = sigma(options_.odom_alpha1 * rot2_2 + options_.odom_alpha2 * trans2);
  step.sigma_trans =
      sigma(options_.odom_alpha3 * trans2 + options_.odom_alpha4 * (rot1_2 + rot2_2));
  return step;
}

void DifferentialDrive::propagate(const Pose2& motion, Particles& particles, Rng& rng) const {
  const Step step = split(motion);
  forEachParticle(particles, rng, [&](Eigen::Index i, Rng& own) {
    const double rot1 = step.rot1 + step.sigma_rot1 * own.normal();
    const double trans = step.trans + step.sigma_trans * own.normal();
    const double rot2 = step.rot2 + step.sigma_rot2 * own.normal();
    const double course = particles.theta[i] + rot1;
    particles.x[i] += trans * std::cos(course) + options_.odom_noise_xy * own.normal();
    particles.y[i] += trans * std::sin(course) + options_.odom_noise_xy * own.normal();
    particles.theta[i] = wrapAngle(course + rot2 + options_.odom_noise_theta * own.normal());
  });
}

Eigen::Matrix3d DifferentialDrive::covariance(const Pose2& motion) const {
  const Step step = split(motion);
  const double c = std::cos(step.rot1);
  const double s = std::sin(step.rot1);
  Eigen::Matrix3d jacobian;  // of (x, y, theta) by (rot1, trans, rot2)
  jacobian << -step.trans * s, c, 0.0, step.trans * c, s, 0.0, 1.0, 0.0, 1.0;
  return noiseCovariance(options_, jacobian, {step.sigma_rot1, step.sigma_trans, step.sigma_rot2});
}

}  // namespace adaptive_localization
