// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/sim/rasterize.hpp"

#include <cmath>
#include <stdexcept>

namespace adaptive_localization {
namespace {

Lattice latticeFor(const FloorPlan& plan, double resolution, int margin) {
  if (!(resolution > 0.0)) {
    throw std::invalid_argument("map resolution: got " + std::to_string(resolution) +
                                ", expected a positive number of metres per cell");
  }
  const Bounds bounds = boundsOf(plan.outline);
  const auto down = [&](double value) { return std::floor(value / resolution + 1e-6) - margin; };
  const auto up = [&](double value) { return std::ceil(value / resolution - 1e-6) + margin; };
  const double x = down(bounds.low.x());
  const double y = down(bounds.low.y());
  const double width = up(bounds.high.x()) - x;
  const double height = up(bounds.high.y()) - y;
  if (!(width * height < 1e8)) {
    throw std::invalid_argument("map resolution: got " + std::to_string(resolution) +
                                ", expected a map of less than 1e8 cells");
  }
  return {static_cast<int>(width),
          static_cast<int>(height),
          resolution,
          {x * resolution, y * resolution, 0.0}};
}

/// Solid cells as a plan is painted: first all, then the inside of the outline free, then walls.
class Canvas {
 public:
  explicit Canvas(const Lattice& lattice) : lattice_(lattice), solid_(lattice.size(), 1) {}

  void paint(const Polygon& polygon, char solid) {
    const Bounds bounds = boundsOf(polygon);
    const Cell low = lattice_.cellAt(bounds.low);
    const Cell high = lattice_.cellAt(bounds.high);
    for (Cell cell = low; cell.y <= high.y; ++cell.y) {
      for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
        if (lattice_.contains(cell) && contains(polygon, lattice_.centre(cell))) {
          solid_[lattice_.index(cell)] = solid;
        }
      }
    }
  }

  void paint(const Segment& line) {
    const Eigen::Vector2d along = line.b - line.a;
    const int steps = static_cast<int>(std::ceil(along.norm() / lattice_.resolution() * 4.0));
    for (int i = 0; i <= steps; ++i) {
      const Cell cell = lattice_.cellAt(line.a + along * (static_cast<double>(i) / steps));
      if (lattice_.contains(cell)) solid_[lattice_.index(cell)] = 1;
    }
  }

  std::int8_t value(const Cell& cell) const {
    if (!isSolid(cell)) return OccupancyGrid::kFree;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (!isSolid({cell.x + dx, cell.y + dy})) return OccupancyGrid::kOccupied;
      }
    }
    return OccupancyGrid::kUnknown;
  }

 private:
  bool isSolid(const Cell& cell) const {
    return !lattice_.contains(cell) || solid_[lattice_.index(cell)] != 0;
  }

  Lattice lattice_;
  std::vector<char> solid_;
};

}  // namespace

OccupancyGrid rasterize(const FloorPlan& plan, double resolution, int margin) {
  const Lattice lattice = latticeFor(plan, resolution, margin);
  Canvas canvas(lattice);
  canvas.paint(plan.outline, 0);
  for (const auto& solid : plan.solids) canvas.paint(solid, 1);
  for (const auto& wall : plan.walls) {
    canvas.paint(thickLine(wall, plan.wall_thickness), 1);
    canvas.paint(wall);
  }
  std::vector<std::int8_t> cells(lattice.size());
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = canvas.value(lattice.cell(i));
  return {lattice, std::move(cells)};
}

}  // namespace adaptive_localization
