// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/observation/composed_model.hpp"

#include <algorithm>

namespace adaptive_localization {

double ComposedModel::score(const Observations& observations, const Particles& particles,
                            Eigen::Ref<Eigen::ArrayXd> log_likelihood) const {
  double independent = 0.0;
  for (const auto& part : parts_) {
    independent += part->score(observations, particles, log_likelihood);
  }
  return independent;
}

std::vector<PoseObservation> ComposedModel::linearized(const Observations& observations,
                                                       const Pose2& T_map_base) const {
  std::vector<PoseObservation> all;
  for (const auto& part : parts_) {
    for (PoseObservation& seen : part->linearized(observations, T_map_base)) {
      all.push_back(std::move(seen));
    }
  }
  return all;
}

bool ComposedModel::canLocalize(const Observations& observations) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const auto& part) { return part->canLocalize(observations); });
}

bool ComposedModel::namesPlaces(const Observations& observations) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const auto& part) { return part->namesPlaces(observations); });
}

std::optional<double> ComposedModel::misfit(const Observations& observations,
                                            const Pose2& T_map_base) const {
  double sum = 0.0;
  int count = 0;
  for (const auto& part : parts_) {
    const auto misfit = part->misfit(observations, T_map_base);
    sum += misfit.value_or(0.0);
    count += misfit.has_value();
  }
  return count > 0 ? std::make_optional(sum / count) : std::nullopt;
}

std::vector<Pose2> ComposedModel::explanations(const Observations& observations,
                                               bool are_samples_asked) const {
  std::vector<Pose2> all;
  for (const auto& part : parts_) {
    const auto some = part->explanations(observations, are_samples_asked);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::unique_ptr<ComposedModel> makeSenses(const Registry<ObservationDescription>& senses,
                                          const Parameters& given,
                                          const std::shared_ptr<const OccupancyGrid>& map,
                                          const std::shared_ptr<const DistanceField>& field) {
  auto all = std::make_unique<ComposedModel>();
  for (const auto& name : senses.names()) {
    all->add(senses.make(name, given, map, field));
  }
  return all;
}

}  // namespace adaptive_localization
