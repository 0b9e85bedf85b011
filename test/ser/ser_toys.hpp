// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>

#include "adaptive_localization/core/rng.hpp"
#include "map/ray_caster.hpp"
#include "ser/global_search.hpp"
#include "sim/rasterize.hpp"
#include "sim/world.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {

using MapPtr = std::shared_ptr<const OccupancyGrid>;

/// The maze that comes with the package, at any resolution, and its polygons.
inline FloorPlan mazePlan() {
  return loadFloorPlan(SOURCE_DIR "/maps/maze/world.yaml");
}
inline MapPtr maze(double resolution = 0.05) {
  return std::make_shared<const OccupancyGrid>(rasterize(mazePlan(), resolution));
}

/// A room of 3 x 2 m with a box in it.
inline MapPtr smallRoom(const Pose2& origin = {}) {
  return toyWorld({"###############",  //
                   "#.........#...#",  //
                   "#.........#...#",  //
                   "#.............#",  //
                   "#...##........#",  //
                   "#...##........#",  //
                   "#.............#",  //
                   "#..........####",  //
                   "#..........#..#",  //
                   "###############"},
                  0.2, origin);
}

/// A laser at the middle of the robot that sees half a circle, in whole directions.
inline ScanGeometry halfCircle(double max_range = 10.0) {
  ScanGeometry geometry;
  geometry.max_range = max_range;
  geometry.first = -45;
  geometry.count = 91;
  return geometry;
}

/// What it reads, a beam in each direction; exact.
inline const ToyLaser kHalfCircle{91, -kPi / 2, kPi / 2, 20.0};

inline std::shared_ptr<const EnergyGrid> gridOf(const MapPtr& map,
                                                const ScanGeometry& geometry = halfCircle(),
                                                const EnergyGridOptions& options = {}) {
  return std::make_shared<const EnergyGrid>(*map, geometry, options);
}

inline std::shared_ptr<const GlobalSearch> searchOn(const std::shared_ptr<const EnergyGrid>& grid,
                                                    const MapPtr& map,
                                                    const GlobalSearchOptions& options = {}) {
  return std::make_shared<const GlobalSearch>(grid, map,
                                              std::make_shared<const DistanceField>(*map), options);
}

/// Gaussian noise on all ranges; some beams read anything, some nothing valid, some no return.
struct Disturbance {
  double noise{0.03};  // m
  double wrong{0.05};  // shares of beams
  double invalid{0.02};
  double no_return{0.02};

  void apply(LaserScan& scan, Rng& rng) const {
    for (float& range : scan.ranges) {
      range += static_cast<float>(rng.normal(0.0, noise));
      const double u = rng.uniform();
      if (u < wrong) {
        range = static_cast<float>(rng.uniform(0.1, 0.6 * scan.range_max));
      } else if (u < wrong + invalid) {
        range = std::numeric_limits<float>::quiet_NaN();
      } else if (u < wrong + invalid + no_return) {
        range = std::numeric_limits<float>::infinity();
      }
    }
  }
};

inline Scan toScan(const LaserScan& message) {
  return toScan(message, LaserMount{}, ScanOptions{});
}

/// A scan as a table has it, with a beam in each of `count` directions from beam 0's.
inline DirectionalScan scanOf(const RangeTable& table, std::size_t cell, int direction, int count) {
  DirectionalScan scan;
  scan.range.fill(-1);
  scan.valid = count;
  for (int k = 0; k < count; ++k) {
    scan.range[static_cast<std::size_t>(k)] = table.ranges(cell)[(direction + k) % kDirections];
  }
  return scan;
}

/// A scan on the table's lattice in which every beam is anything: a step, a no-return or invalid.
inline DirectionalScan randomScan(Rng& rng, int count) {
  DirectionalScan scan;
  scan.range.fill(-1);
  const double invalid = rng.uniform();
  const auto farthest = 1 + rng.below(256);
  for (int k = 0; k < count; ++k) {
    if (rng.uniform() < invalid) continue;
    scan.range[static_cast<std::size_t>(k)] = static_cast<std::int16_t>(rng.below(farthest));
    ++scan.valid;
  }
  return scan;
}

}  // namespace adaptive_localization
