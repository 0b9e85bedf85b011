// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/observation/observation_model.hpp"

namespace adaptive_localization {

/// What a compass says of a pose. With d the difference of the headings, sigma its standard
/// deviation and p the probability that the field is disturbed, by steel in a floor say,
///
///     log p(heading | pose) = log((1 - p) exp(-d^2 / (2 sigma^2)) + p)
///
/// Kalman filters take it for a linear observation of theta.
class HeadingPrior : public ObservationModel {
 public:
  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override;

  std::vector<PoseObservation> linearized(const Observations& observations,
                                          const Pose2& T_map_base) const override;

  double mostInAll() const override { return 7.0; }
};

}  // namespace adaptive_localization
