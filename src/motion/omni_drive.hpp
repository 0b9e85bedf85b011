// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/motion/motion_model.hpp"

namespace adaptive_localization {

/// Odometry motion model of a robot that moves in any direction: trans along its course, a strafe
/// across it, and a rotation rot. With `omni-corrected` the standard deviations are
///
///     trans:  sqrt(alpha3 trans^2 + alpha4 rot^2)
///     strafe: sqrt(alpha5 trans^2 + alpha4 rot^2)
///     rot:    sqrt(alpha1 rot^2 + alpha2 trans^2)
///
/// with `omni`, amcl's older model, the roots are missing and alpha1 and alpha4 change places.
class OmniDrive : public MotionModel {
 public:
  explicit OmniDrive(const MotionOptions& options, NoiseRule rule = NoiseRule::kVariances)
      : options_(options), rule_(rule) {}

  void propagate(const Pose2& motion, Particles& particles, Rng& rng) const override;
  Eigen::Matrix3d covariance(const Pose2& motion) const override;

 private:
  struct Step;
  Step split(const Pose2& motion) const;

  MotionOptions options_;
  NoiseRule rule_;
};

}  // namespace adaptive_localization
