// SPDX-License-Identifier: BSD-3-Clause
#include "prepared_map.hpp"

#include <cstdint>
#include <utility>

#include "match/surface_maps.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {

PreparedMap::PreparedMap(std::shared_ptr<const SetupReader> the_reader, Setup the_setup,
                         Ground the_ground)
    : reader(std::move(the_reader)), setup(std::move(the_setup)), ground(std::move(the_ground)) {
  if (!ground.places) {
    ground.places = std::make_shared<Places>(ground.map, ground.field,
                                             setup.parameters.read<EnergyGridOptions>(),
                                             setup.parameters.read<GlobalSearchOptions>());
  }
  if (!ground.surfaces) {
    ground.surfaces = std::make_shared<SurfaceMaps>(ground.map, ground.field->quality());
  }
  const Registries& registries = reader->registries();
  const FilterContext context{registries, ground, setup.parameters,
                              static_cast<std::uint64_t>(setup.options.seed)};
  filter = registries.filters.make(setup.options.filter, context);
  senses = makeSenses(registries.senses, context.parameters, ground.map, ground.field);
  if (setup.options.refine) {
    refiner = makeEstimateRefiner(registries.motions, context.parameters, ground, senses);
  }
  setup.parameters = context.parameters;  // knows what the filter has read
}

}  // namespace adaptive_localization
