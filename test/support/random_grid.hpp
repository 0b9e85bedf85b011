// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// A grid whose cells are occupied with a probability, unknown with a tenth, else free.
inline std::shared_ptr<const OccupancyGrid> randomGrid(Rng& rng, const Lattice& lattice,
                                                       double occupied) {
  std::vector<std::int8_t> cells(lattice.size());
  for (auto& cell : cells) {
    const double u = rng.uniform();
    cell = u < occupied         ? OccupancyGrid::kOccupied
           : u < occupied + 0.1 ? OccupancyGrid::kUnknown
                                : OccupancyGrid::kFree;
  }
  return std::make_shared<const OccupancyGrid>(lattice, std::move(cells));
}

}  // namespace adaptive_localization
