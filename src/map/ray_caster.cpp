// SPDX-License-Identifier: BSD-3-Clause
#include "map/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

constexpr double kLeastJump = 2.0;  // cells: less is sooner walked

/// The traversal along one axis, in cells.
struct Axis {
  Axis(double start_at, double towards)
      : start(start_at),
        direction(towards),
        cell(static_cast<int>(std::floor(start_at))),
        step(towards > 0.0 ? 1 : -1) {
    if (direction == 0.0) return;
    per_cell = 1.0 / std::abs(direction);
    next = leavesAfter();
  }

  void advance() {
    cell += step;
    next += per_cell;
  }

  /// To a place along the ray.
  void goTo(double way) {
    if (direction == 0.0) return;
    cell = static_cast<int>(start + way * direction + 1.0) - 1;  // rounded down, on the lattice
    next = leavesAfter();
  }

  double leavesAfter() const {
    return (direction > 0.0 ? cell + 1 - start : start - cell) * per_cell;
  }

  double start, direction;
  int cell;
  int step;
  double per_cell{std::numeric_limits<double>::infinity()};
  double next{std::numeric_limits<double>::infinity()};  // along the ray, where the cell is left
};

/// How far a ray in a cell that is no wall's goes on without meeting one, at the least, in cells:
/// distances are from centre to centre. In rock, where the field has no walls, there is no such
/// cell.
double clearWay(const DistanceField* field, const Cell& cell) {
  constexpr double kDiagonal = 1.4143;  // of two half cells, and a little for rounding
  return field && field->lattice().contains(cell) ? field->cellsTo(cell) - kDiagonal : 0.0;
}

/// Where along the ray the strip [0, size] of one axis is entered and left.
void clip(double start, double direction, double size, double& enter, double& leave) {
  if (direction == 0.0) {
    if (start < 0.0 || start >= size) leave = -1.0;
    return;
  }
  const double a = -start / direction;
  const double b = (size - start) / direction;
  enter = std::max(enter, std::min(a, b));
  leave = std::min(leave, std::max(a, b));
}

}  // namespace

RayCaster::Wall RayCaster::wall(const Pose2& T_map_ray, double max_range, double depth) const {
  const Wall none{max_range, max_range};
  const Lattice& lattice = grid_->lattice();
  const Pose2 ray = lattice.toLattice(T_map_ray);
  if (!isFinite(ray)) return none;
  const double resolution = lattice.resolution();
  const double dx = std::cos(ray.theta);
  const double dy = std::sin(ray.theta);
  const double x = ray.x / resolution;
  const double y = ray.y / resolution;

  double travelled = 0.0;
  double end = max_range / resolution;
  clip(x, dx, lattice.width(), travelled, end);
  clip(y, dy, lattice.height(), travelled, end);
  if (!(travelled <= end)) return none;

  const double skipped = travelled > 0.0 ? travelled + 1e-9 : 0.0;  // step over the map's border
  Axis column(x + skipped * dx, dx);
  Axis row(y + skipped * dy, dy);
  travelled = skipped;
  const double inside = 0.5 / std::max(std::abs(dx), std::abs(dy));
  Wall wall = none;
  bool is_in_wall = false;
  const OccupancyGrid& grid = *grid_;
  while (travelled < end) {
    const Cell cell{column.cell, row.cell};
    if (grid.endsBeams(cell)) {
      const double at = std::min((travelled + inside) * resolution, max_range);
      if (!is_in_wall) wall = {at, at};
      if (at - wall.near > depth) return wall;
      is_in_wall = true;
      wall.far = at;
      if (depth == 0.0) return wall;
    } else if (is_in_wall) {
      return wall;
    } else if (const double clear = clearWay(field_.get(), cell); clear > kLeastJump) {
      travelled += clear;
      column.goTo(travelled - skipped);
      row.goTo(travelled - skipped);
      continue;
    }
    Axis& nearer = column.next < row.next ? column : row;
    travelled = skipped + nearer.next;
    nearer.advance();
  }
  return wall;
}

}  // namespace adaptive_localization
