// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "map/ray_caster.hpp"

namespace adaptive_localization {

using Art = std::vector<std::string>;

/// A map from ASCII art, the top row first: '#' occupied, '.' free, '?' unknown. Each character is
/// a square of cells_per_character cells a side.
inline std::shared_ptr<const OccupancyGrid> toyWorld(const Art& art, double resolution,
                                                     const Pose2& origin = {},
                                                     int cells_per_character = 1) {
  const int rows = static_cast<int>(art.size());
  const int columns = static_cast<int>(art.front().size());
  const Lattice lattice(columns * cells_per_character, rows * cells_per_character, resolution,
                        origin);
  std::vector<std::int8_t> cells(lattice.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = lattice.cell(i);
    const auto row = static_cast<std::size_t>(rows - 1 - cell.y / cells_per_character);
    const char drawn = art[row].at(static_cast<std::size_t>(cell.x / cells_per_character));
    cells[i] = drawn == '#'   ? OccupancyGrid::kOccupied
               : drawn == '.' ? OccupancyGrid::kFree
                              : OccupancyGrid::kUnknown;
  }
  return std::make_shared<const OccupancyGrid>(lattice, std::move(cells));
}

/// The map with only the faces of its walls: what is behind them is unknown, as after mapping.
inline std::shared_ptr<const OccupancyGrid> hollow(const OccupancyGrid& map) {
  std::vector<std::int8_t> cells = map.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell cell = map.lattice().cell(i);
    bool behind = true;
    for (int d = 0; d < 9; ++d) behind &= !map.isFree({cell.x + d % 3 - 1, cell.y + d / 3 - 1});
    if (behind) cells[i] = OccupancyGrid::kUnknown;
  }
  return std::make_shared<const OccupancyGrid>(map.lattice(), std::move(cells));
}

/// Three rooms of 10 m by 5 m together in which no two places look alike; cells of 5 cm.
inline std::shared_ptr<const OccupancyGrid> asymmetricWorld(const Pose2& origin = {}) {
  return hollow(*toyWorld({"####################",  //
                           "#........#.........#",  //
                           "#........#.........#",  //
                           "#........#...####..#",  //
                           "#..................#",  //
                           "#...##.............#",  //
                           "#...##......########",  //
                           "#...........#......#",  //
                           "#..................#",  //
                           "####################"},
                          0.05, origin, 10));
}

/// A room of 6 m by 3 m that looks the same when turned by half a turn.
inline std::shared_ptr<const OccupancyGrid> symmetricWorld() {
  return hollow(*toyWorld({"############",  //
                           "#..#.......#",  //
                           "#..#.......#",  //
                           "#.......#..#",  //
                           "#.......#..#",  //
                           "############"},
                          0.05, {}, 10));
}

/// A laser with evenly spread beams, and what it reads at a pose of the sensor in a map.
struct ToyLaser {
  int beams{181};
  double angle_min{-kPi / 2};
  double angle_max{kPi / 2};
  double max_range{20.0};

  LaserScan read(const std::shared_ptr<const OccupancyGrid>& map, const Pose2& T_map_laser) const {
    LaserScan scan;
    scan.angle_min = angle_min;
    scan.angle_increment = (angle_max - angle_min) / std::max(1, beams - 1);
    scan.range_min = 0.01;
    scan.range_max = max_range;
    const RayCaster caster(map);
    for (int i = 0; i < beams; ++i) {
      const double bearing = angle_min + i * scan.angle_increment;
      const double range =
          caster.range({T_map_laser.x, T_map_laser.y, T_map_laser.theta + bearing}, max_range);
      scan.ranges.push_back(range < max_range ? static_cast<float>(range)
                                              : std::numeric_limits<float>::infinity());
    }
    return scan;
  }

  /// The same as an observation by a robot whose base is where the laser is.
  Observations observe(const std::shared_ptr<const OccupancyGrid>& map,
                       const Pose2& T_map_base) const {
    ScanOptions options;
    options.laser_max_beams = beams;
    return {0.0, toScan(read(map, T_map_base), LaserMount{}, options)};
  }
};

/// A scan with the given end points and nothing else.
inline Observations hitsAt(const std::vector<Eigen::Vector2d>& points, double max_range) {
  Observations observations;
  Scan& scan = observations.scan;
  scan.max_range = max_range;
  const auto count = static_cast<Eigen::Index>(points.size());
  for (auto* column : {&scan.x, &scan.y, &scan.range, &scan.bearing}) column->resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector2d& point = points[static_cast<std::size_t>(i)];
    scan.x[i] = static_cast<float>(point.x());
    scan.y[i] = static_cast<float>(point.y());
    scan.range[i] = static_cast<float>(point.norm());
    scan.bearing[i] = static_cast<float>(std::atan2(point.y(), point.x()));
  }
  return observations;
}

}  // namespace adaptive_localization
