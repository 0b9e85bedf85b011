// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/observation/observation_model.hpp"

namespace adaptive_localization {

/// Several models as one. What different senses observe is independent, given the pose:
///
///     log p(z_1 ... z_n | x) = sum_k log p(z_k | x)
class ComposedModel : public ObservationModel {
 public:
  void add(std::unique_ptr<ObservationModel> part) { parts_.push_back(std::move(part)); }

  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override;

  std::vector<PoseObservation> linearized(const Observations& observations,
                                          const Pose2& T_map_base) const override;

  bool canLocalize(const Observations& observations) const override;

  bool namesPlaces(const Observations& observations) const override;

  /// The mean of those that tell.
  std::optional<double> misfit(const Observations& observations,
                               const Pose2& T_map_base) const override;

  std::vector<Pose2> explanations(const Observations& observations,
                                  bool are_samples_asked) const override;

  const std::vector<std::unique_ptr<ObservationModel>>& parts() const { return parts_; }

 private:
  std::vector<std::unique_ptr<ObservationModel>> parts_;
};

/// Immutable, for all that listen.
using Senses = std::shared_ptr<const ComposedModel>;

inline Senses noSenses() {
  return std::make_shared<ComposedModel>();
}

/// The models of all senses beside the laser, which all cores listen to. A sense that observed
/// nothing says nothing.
std::unique_ptr<ComposedModel> makeSenses(const Registry<ObservationDescription>& senses,
                                          const Parameters& given,
                                          const std::shared_ptr<const OccupancyGrid>& map,
                                          const std::shared_ptr<const DistanceField>& field);

}  // namespace adaptive_localization
