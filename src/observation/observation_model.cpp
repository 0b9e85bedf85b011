// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/observation/observation_model.hpp"

#include "adaptive_localization/observation/likelihood_field.hpp"
#include "adaptive_localization/observation/range_models.hpp"

namespace adaptive_localization {

std::unique_ptr<ObservationModel> makeObservationModel(const ObservationOptions& options,
                                                       std::shared_ptr<const OccupancyGrid> map,
                                                       std::shared_ptr<const DistanceField> field) {
  if (options.laser_model_type == "beam") {
    return std::make_unique<BeamModel>(options, std::move(map));
  }
  if (options.laser_model_type == "inverse_l1") return std::make_unique<InverseL1>(std::move(map));
  return std::make_unique<LikelihoodField>(options, std::move(field));
}

}  // namespace adaptive_localization
