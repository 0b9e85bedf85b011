// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Dense>

#include "adaptive_localization/core/belief.hpp"
#include "swarm/field_objective.hpp"

namespace adaptive_localization {

/// Distances of hits, and how far odometry is from there:
///
///     F + s d^2 / 2,   d^2 = (x - odometry)^T P^-1 (x - odometry)
class NearObjective : public Objective {
 public:
  NearObjective(FieldObjective field, const Gaussian2& odometry)
      : field_(std::move(field)),
        mean_(odometry.mean.x, odometry.mean.y, odometry.mean.theta),
        information_(odometry.covariance.inverse()) {
    if (!information_.allFinite()) information_.setZero();
  }

  void evaluate(const Eigen::ArrayXXd& positions, Eigen::Ref<Eigen::ArrayXd> costs) const override {
    field_.evaluate(positions, costs);
    for (Eigen::Index i = 0; i < positions.rows(); ++i) {
      Eigen::Vector3d off = positions.row(i).matrix().transpose() - mean_;
      off.z() = wrapAngle(off.z());
      costs[i] += 0.5 * kScale * off.dot(information_ * off);
    }
  }

 private:
  static constexpr double kScale = 0.005;  // m: what half a d^2 is worth

  FieldObjective field_;
  Eigen::Vector3d mean_;
  Eigen::Matrix3d information_;
};

}  // namespace adaptive_localization
