// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/sim/survey.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace adaptive_localization {
namespace {

constexpr double kTurn = 0.1;  // rad
constexpr int kMargin = 5;     // cells

Lattice latticeFor(const FloorPlan& plan, double resolution) {
  const Pose2 T_turned_map = inverse(Pose2{0.0, 0.0, kTurn});
  Polygon turned;
  for (const auto& corner : plan.outline) turned.push_back(T_turned_map * corner);
  const Bounds bounds = boundsOf(turned);
  const Eigen::Vector2d size =
      (bounds.high - bounds.low) / resolution + Eigen::Vector2d::Constant(2.0 * kMargin);
  if (!(resolution > 0.0 && size.x() * size.y() < 1e8)) {
    throw std::invalid_argument("map resolution: got " + std::to_string(resolution) +
                                ", expected one that gives a map of less than 1e8 cells");
  }
  const Eigen::Vector2d corner = bounds.low - Eigen::Vector2d::Constant(kMargin * resolution);
  return {static_cast<int>(std::ceil(size.x())), static_cast<int>(std::ceil(size.y())), resolution,
          Pose2{0.0, 0.0, kTurn} * Pose2{corner.x(), corner.y(), 0.0}};
}

std::vector<Polygon> solidsOf(const FloorPlan& plan) {
  std::vector<Polygon> solids = plan.solids;
  for (const auto& wall : plan.walls) solids.push_back(thickLine(wall, plan.wall_thickness));
  return solids;
}

bool isFree(const FloorPlan& plan, const std::vector<Polygon>& solids,
            const Eigen::Vector2d& point) {
  return contains(plan.outline, point) &&
         std::none_of(solids.begin(), solids.end(),
                      [&](const Polygon& solid) { return contains(solid, point); });
}

}  // namespace

OccupancyGrid survey(const FloorPlan& plan, double resolution) {
  const Lattice lattice = latticeFor(plan, resolution);
  const std::vector<Polygon> solids = solidsOf(plan);
  std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kUnknown);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (isFree(plan, solids, lattice.centre(lattice.cell(i)))) cells[i] = OccupancyGrid::kFree;
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
