// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "adaptive_localization/map/map_quality.hpp"
#include "match/surface_map.hpp"

namespace adaptive_localization {

/// The surfaces of a map, one for all that match scans with it: made when they are asked for, and
/// there as long as somebody has them. May be asked by several threads.
class SurfaceMaps {
 public:
  SurfaceMaps(std::shared_ptr<const OccupancyGrid> map, const MapQuality& quality)
      : map_(std::move(map)), quality_(quality) {}

  const OccupancyGrid& map() const { return *map_; }

  /// The faces of the walls, with labels that reach so far beyond them, m.
  std::shared_ptr<const SurfaceMap> faces(double reach);

  /// The same of the middles of the walls where the map has thick ones; otherwise null.
  std::shared_ptr<const SurfaceMap> middles(double reach);

 private:
  struct Kept {
    double reach{0.0};
    std::weak_ptr<const SurfaceMap> surfaces;
  };
  using Make = std::function<std::shared_ptr<const SurfaceMap>()>;

  std::shared_ptr<const SurfaceMap> keep(Kept& kept, double reach, const Make& make);

  std::shared_ptr<const OccupancyGrid> map_;
  MapQuality quality_;
  std::mutex mutex_;
  Kept faces_, middles_;
};

}  // namespace adaptive_localization
