// SPDX-License-Identifier: BSD-3-Clause
#include "elsewhere.hpp"

namespace adaptive_localization {

std::shared_ptr<Places> placesFor(const FilterContext& context) {
  const auto grid = context.parameters.read<EnergyGridOptions>();
  const auto search = context.parameters.read<GlobalSearchOptions>();
  if (context.ground.places) return context.ground.places;
  return std::make_shared<Places>(context.ground.map, context.ground.field, grid, search);
}

std::unique_ptr<PoseSampler> makeSampler(const FilterContext& context,
                                         const std::shared_ptr<Places>& places) {
  const auto options = context.parameters.read<PlaceSamplerOptions>();
  const std::string where = context.parameters.read<ElsewhereOptions>().elsewhere;
  if (where == "ser") return std::make_unique<SerSampler>(places, context.ground.map);
  if (where == "free") return std::make_unique<FreeSpaceSampler>(context.ground.map);
  return std::make_unique<PlaceSampler>(options, places, context.ground.map);
}

}  // namespace adaptive_localization
