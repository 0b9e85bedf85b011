// SPDX-License-Identifier: BSD-3-Clause
#include "shared_parts.hpp"

#include "match/surface_maps.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {

std::shared_ptr<Places> placesFor(const Ground& ground, const Parameters& given) {
  const auto grid = given.read<EnergyGridOptions>();
  const auto search = given.read<GlobalSearchOptions>();
  if (ground.places) return ground.places;
  return std::make_shared<Places>(ground.map, ground.field, grid, search);
}

ScanMatcher scanMatcherFor(const Ground& ground, const MatchOptions& options) {
  if (ground.surfaces) return makeScanMatcher(options, *ground.surfaces);
  SurfaceMaps own(ground.map, ground.field->quality());
  return makeScanMatcher(options, own);
}

}  // namespace adaptive_localization
