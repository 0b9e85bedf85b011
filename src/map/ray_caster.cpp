// SPDX-License-Identifier: BSD-3-Clause
#include "map/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

/// The traversal along one axis, in cells.
struct Axis {
  Axis(double start_at, double towards)
      : start(start_at),
        direction(towards),
        cell(static_cast<int>(std::floor(start_at))),
        step(towards > 0.0 ? 1 : -1) {
    if (direction == 0.0) return;
    per_cell = 1.0 / std::abs(direction);
    aim();
  }

  void advance() {
    cell += step;
    next += per_cell;
  }

  /// To a place along the ray; aim() is due thereafter.
  void goTo(double way) {
    cell = static_cast<int>(start + way * direction + 1.0) - 1;  // rounded down, on the lattice
  }

  /// At the side by which the cell is left.
  void aim() {
    if (direction == 0.0) return;
    next = (direction > 0.0 ? cell + 1 - start : start - cell) * per_cell;
  }

  double start, direction;
  int cell;
  int step;
  double per_cell{std::numeric_limits<double>::infinity()};
  double next{std::numeric_limits<double>::infinity()};  // along the ray, where the cell is left
};

/// A ray's way over the cells.
struct Walk {
  Axis column, row;
  double start;  // where the ray comes to the map, and where it is, in cells
  double travelled{start};
  bool is_aimed{true};

  Cell cell() const { return {column.cell, row.cell}; }

  void step() {
    if (!is_aimed) {
      column.aim();
      row.aim();
      is_aimed = true;
    }
    Axis& nearer = column.next < row.next ? column : row;
    travelled = start + nearer.next;
    nearer.advance();
  }

  void jump(double way) {
    travelled += way;
    column.goTo(travelled - start);
    row.goTo(travelled - start);
    is_aimed = false;
  }
};

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

/// To the first cell that beams end at; false if there is none. The field tells how far a ray goes
/// on without meeting a wall, at the least. Deep in rock, where a ray may begin, it has none.
bool goToWall(const OccupancyGrid& grid, const DistanceField* field, double end, Walk& walk) {
  constexpr double kDiagonal = 1.4143;  // of two half cells: distances are from centre to centre
  constexpr double kLeastJump = 2.0;    // cells: less is sooner walked
  const auto distance = [&] {           // to the nearest wall, in cells
    const Cell cell = walk.cell();
    if (field && field->lattice().contains(cell)) return field->cellsTo(cell);
    return grid.endsBeams(cell) ? 0.0 : 1.0;
  };
  if (!(walk.travelled < end)) return false;
  double free = grid.endsBeams(walk.cell()) ? 0.0 : distance();
  while (free > 0.0) {
    const double clear = free - kDiagonal;
    clear > kLeastJump ? walk.jump(clear) : walk.step();
    if (!(walk.travelled < end)) return false;
    free = distance();
  }
  return true;
}

}  // namespace

RayCaster::Wall RayCaster::wall(const Pose2& T_map_ray, double max_range, double depth,
                                double until) const {
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
  Walk walk{{x + skipped * dx, dx}, {y + skipped * dy, dy}, skipped};
  if (!goToWall(*grid_, field_.get(), end, walk)) return none;
  const double inside = 0.5 / std::max(std::abs(dx), std::abs(dy));
  const auto middle = [&] { return std::min((walk.travelled + inside) * resolution, max_range); };
  Wall wall{middle(), middle()};
  while (depth > 0.0 && wall.far < until) {
    walk.step();
    if (!(walk.travelled < end) || !grid_->endsBeams(walk.cell())) break;
    if (middle() - wall.near > depth) break;
    wall.far = middle();
  }
  return wall;
}

}  // namespace adaptive_localization
