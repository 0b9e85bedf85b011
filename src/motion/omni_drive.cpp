// SPDX-License-Identifier: BSD-3-Clause
#include "motion/omni_drive.hpp"

#include <cmath>

#include "noise.hpp"

namespace adaptive_localization {

struct OmniDrive::Step {
  double course, trans, rot;                    // rad in the previous frame, m, rad
  double sigma_trans, sigma_strafe, sigma_rot;  // standard deviations
};

OmniDrive::Step OmniDrive::split(const Pose2& motion) const {
  Step step{};
  step.trans = std::hypot(motion.x, motion.y);
  step.course = step.trans > 0.0 ? std::atan2(motion.y, motion.x) : 0.0;
  step.rot = wrapAngle(motion.theta);

  const MotionOptions& a = options_;
  const double trans2 = step.trans * step.trans;
  const double rot2 = step.rot * step.rot;
  if (rule_ == NoiseRule::kVariances) {
    step.sigma_trans = std::sqrt(a.odom_alpha3 * trans2 + a.odom_alpha4 * rot2);
    step.sigma_strafe = std::sqrt(a.odom_alpha5 * trans2 + a.odom_alpha4 * rot2);
    step.sigma_rot = std::sqrt(a.odom_alpha1 * rot2 + a.odom_alpha2 * trans2);
  } else {
    step.sigma_trans = a.odom_alpha3 * trans2 + a.odom_alpha1 * rot2;
    step.sigma_strafe = a.odom_alpha5 * trans2 + a.odom_alpha1 * rot2;
    step.sigma_rot = a.odom_alpha4 * rot2 + a.odom_alpha2 * trans2;
  }
  return step;
}

void OmniDrive::propagate(const Pose2& motion, Particles& particles, Rng& rng) const {
  const Step step = split(motion);
  forEachParticle(particles, rng, [&](Eigen::Index i, Rng& own) {
    const double trans = step.trans + step.sigma_trans * own.normal();
    const double strafe = step.sigma_strafe * own.normal();
    const double rot = step.rot + step.sigma_rot * own.normal();
    const double c = std::cos(particles.theta[i] + step.course);
    const double s = std::sin(particles.theta[i] + step.course);
    particles.x[i] += trans * c - strafe * s + options_.odom_noise_xy * own.normal();
    particles.y[i] += trans * s + strafe * c + options_.odom_noise_xy * own.normal();
    particles.theta[i] =
        wrapAngle(particles.theta[i] + rot + options_.odom_noise_theta * own.normal());
  });
}

Eigen::Matrix3d OmniDrive::covariance(const Pose2& motion) const {
  const Step step = split(motion);
  const double c = std::cos(step.course);
  const double s = std::sin(step.course);
  Eigen::Matrix3d jacobian;  // of (x, y, theta) by (trans, strafe, rot)
  jacobian << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  return noiseCovariance(options_, jacobian, {step.sigma_trans, step.sigma_strafe, step.sigma_rot});
}

}  // namespace adaptive_localization
