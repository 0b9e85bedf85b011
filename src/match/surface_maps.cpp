// SPDX-License-Identifier: BSD-3-Clause
#include "match/surface_maps.hpp"

#include "map/thin_walls.hpp"

namespace adaptive_localization {

std::shared_ptr<const SurfaceMap> SurfaceMaps::faces(double reach) {
  return keep(faces_, reach, [&] { return std::make_shared<const SurfaceMap>(*map_, reach); });
}

std::shared_ptr<const SurfaceMap> SurfaceMaps::middles(double reach) {
  if (!quality_.hasThickWalls()) return nullptr;
  return keep(middles_, reach, [&] {
    return std::make_shared<const SurfaceMap>(withThinWalls(*map_, quality_.wallDepth()), reach);
  });
}

std::shared_ptr<const SurfaceMap> SurfaceMaps::keep(Kept& kept, double reach, const Make& make) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto surfaces = kept.surfaces.lock();
  if (surfaces && kept.reach == reach) return surfaces;
  surfaces = make();
  kept = {reach, surfaces};
  return surfaces;
}

}  // namespace adaptive_localization
