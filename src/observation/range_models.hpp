// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/observation/observation_model.hpp"
#include "map/ray_caster.hpp"

namespace adaptive_localization {

/// Beam model (Thrun, Burgard, Fox, Probabilistic Robotics, table 6.1): with z the range read and
/// z* the one expected by exact ray casting,
///
///     p = z_hit exp(-(z - z*)^2 / (2 sigma_hit^2)) + [z < z*] z_short lambda exp(-lambda z)
///         + [no-return] z_max + [hit] z_rand / max_range
///
/// and the scan's worth is the sum of log p, tempered as in likelihood_field. Knows occlusion,
/// which the likelihood field does not; a hundred times slower.
class BeamModel : public ObservationModel {
 public:
  BeamModel(const ObservationOptions& options, std::shared_ptr<const OccupancyGrid> map,
            std::shared_ptr<const DistanceField> field)
      : options_(options), ray_caster_(std::move(map), field) {
    options_.laser_sigma_hit = sigmaHit(options, field->quality());
  }

  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override;

 private:
  double logLikelihood(const Scan& scan, const Pose2& T_map_base) const;

  ObservationOptions options_;
  RayCaster ray_caster_;
};

/// Weight of the source system of SAMCL and SA-KLD: w = 1 / sum_i |z_i* - z_i| over the valid
/// beams, a no-return counting as max_range; the sum is at least a millimetre.
class InverseL1 : public ObservationModel {
 public:
  InverseL1(std::shared_ptr<const OccupancyGrid> map, std::shared_ptr<const DistanceField> field)
      : ray_caster_(std::move(map), std::move(field)) {}

  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override;

 private:
  RayCaster ray_caster_;
};

}  // namespace adaptive_localization
