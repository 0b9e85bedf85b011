// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rasterize.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace adaptive_localization {
namespace {

constexpr double kMargin = 5.0;  // cells

/// The map's origin is in the centre of a cell.
Lattice latticeFor(const FloorPlan& plan, double resolution, double turn) {
  const Pose2 T_turned_map = inverse(Pose2{0.0, 0.0, turn});
  Polygon turned;
  for (const auto& corner : plan.outline) turned.push_back(T_turned_map * corner);
  const Bounds bounds = boundsOf(turned);
  const Eigen::Vector2d low = (bounds.low / resolution).array().round() - kMargin - 0.5;
  const Eigen::Vector2d high = (bounds.high / resolution).array().round() + kMargin + 0.5;
  const Eigen::Vector2d size = high - low;
  if (!(resolution > 0.0 && size.x() * size.y() < 1e8)) {
    throw std::invalid_argument("map resolution: got " + std::to_string(resolution) +
                                ", expected one that gives a map of less than 1e8 cells");
  }
  return {static_cast<int>(size.x()), static_cast<int>(size.y()), resolution,
          Pose2{0.0, 0.0, turn} * Pose2{low.x() * resolution, low.y() * resolution, 0.0}};
}

}  // namespace

OccupancyGrid rasterize(const FloorPlan& plan, double resolution, double turn) {
  const Lattice lattice = latticeFor(plan, resolution, turn);
  const std::vector<Polygon> solids = solidsOf(plan);
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d centre = lattice.centre(lattice.cell(i));
    if (isFree(plan.outline, solids, centre)) cells[i] = OccupancyGrid::kFree;
  }
  for (const auto& surface : surfacesOf(plan)) {
    const Eigen::Vector2d along = surface.b - surface.a;
    const int steps = static_cast<int>(std::ceil(along.norm() / resolution * 20.0));
    for (int i = 0; i <= steps; ++i) {
      const Cell cell = lattice.cellAt(surface.a + along * (static_cast<double>(i) / steps));
      cells[lattice.index(cell)] = OccupancyGrid::kOccupied;
    }
  }
  return {lattice, std::move(cells)};
}

}  // namespace adaptive_localization
