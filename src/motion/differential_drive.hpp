// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/motion/motion_model.hpp"

namespace adaptive_localization {

/// Odometry motion model of a robot that turns and drives: turn by rot1, drive trans, turn by rot2
/// (Thrun, Burgard, Fox, Probabilistic Robotics, table 5.6). With `diff-corrected` the standard
/// deviations are
///
///     rot1, rot2: sqrt(alpha1 rot^2 + alpha2 trans^2)
///     trans:      sqrt(alpha3 trans^2 + alpha4 (rot1^2 + rot2^2))
///
/// with `diff` the same without the root, which is amcl's misreading, kept so that tuned values go
/// on to mean what they meant. A backward drive is one of negative trans, not two turns by pi.
/// Prefer the omni model for robots that can move sideways.
class DifferentialDrive : public MotionModel {
 public:
  explicit DifferentialDrive(const MotionOptions& options, NoiseRule rule = NoiseRule::kVariances)
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
