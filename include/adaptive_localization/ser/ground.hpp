// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

class Places;
class SurfaceMaps;

/// A map and what is made from it once for all that use it. Map and field are immutable; the places
/// tell where in the map a scan can have been taken, the surfaces what scans are matched with, and
/// both cost nothing until they are asked.
struct Ground {
  Ground() = default;

  /// Makes the field where it is not given. Without places or surfaces, each user makes its own.
  Ground(std::shared_ptr<const OccupancyGrid> the_map,
         std::shared_ptr<const DistanceField> the_field = nullptr,
         std::shared_ptr<Places> the_places = nullptr)
      : map(std::move(the_map)), field(std::move(the_field)), places(std::move(the_places)) {
    if (map && !field) field = std::make_shared<const DistanceField>(*map);
  }

  std::shared_ptr<const OccupancyGrid> map;
  std::shared_ptr<const DistanceField> field;
  std::shared_ptr<Places> places;
  std::shared_ptr<SurfaceMaps> surfaces;
};

}  // namespace adaptive_localization
