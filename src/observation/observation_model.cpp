// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/observation/observation_model.hpp"

#include "adaptive_localization/observation/likelihood_field.hpp"
#include "adaptive_localization/observation/range_models.hpp"

namespace adaptive_localization {

std::unique_ptr<ObservationModel> makeObservationModel(const ObservationOptions& options,
                                                       const FilterContext& context) {
  if (options.laser_model_type == "beam") {
    return std::make_unique<BeamModel>(options, context.map);
  }
  if (options.laser_model_type == "inverse_l1") return std::make_unique<InverseL1>(context.map);
  return std::make_unique<LikelihoodField>(options, context.distance_field);
}

}  // namespace adaptive_localization
