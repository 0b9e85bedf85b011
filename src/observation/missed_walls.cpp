// SPDX-License-Identifier: BSD-3-Clause
#include "missed_walls.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kChunk = 256;  // particles

/// Every so many-th no-return is looked at.
Eigen::Index strideFor(Eigen::Index beams, Eigen::Index particles) {
  constexpr Eigen::Index kRays = 30000, kFewest = 6, kMost = 24;
  const Eigen::Index wanted = std::clamp(kRays / particles, kFewest, kMost);
  return (beams + wanted - 1) / wanted;
}

/// The directions of these, in base.
std::vector<Eigen::Vector2d> directionsOf(const Scan& scan, Eigen::Index stride) {
  std::vector<Eigen::Vector2d> directions;
  for (Eigen::Index i = stride / 2; i < scan.no_return_bearing.size(); i += stride) {
    const auto bearing = static_cast<double>(scan.no_return_bearing[i]);
    directions.emplace_back(std::cos(bearing), std::sin(bearing));
  }
  return directions;
}

/// How far a point is from the nearest wall, all in cells.
double cellsFree(const DistanceField& field, const Eigen::Vector2d& point) {
  const Lattice& lattice = field.lattice();
  const bool is_inside = point.x() >= 0.0 && point.x() < lattice.width() && point.y() >= 0.0 &&
                         point.y() < lattice.height();
  if (!is_inside) return field.reach() / lattice.resolution();
  return field.cellsTo({static_cast<int>(point.x()), static_cast<int>(point.y())});
}

/// Whether a ray meets a wall, all in cells: it goes on at once by as much as no wall is nearer.
/// Where the wall is does not matter, nor a corner that is cut, so no RayCaster, which walks from
/// cell to cell, is needed.
bool meetsWall(const DistanceField& field, const Eigen::Vector2d& start,
               const Eigen::Vector2d& direction, double from, double until) {
  constexpr double kInWall = 0.5, kHalfDiagonal = 0.7;
  for (double way = from; way < until;) {
    const double free = cellsFree(field, start + way * direction);
    if (free < kInWall) return true;
    way += std::max(free - kHalfDiagonal, kHalfDiagonal);
  }
  return false;
}

/// How many of some beams meet a wall, of those that do so beside another one.
template <class Meets>
int sideBySide(const std::vector<Eigen::Vector2d>& directions, const Meets& meets) {
  int count = 0, in_a_row = 0;
  for (const Eigen::Vector2d& direction : directions) {
    in_a_row = meets(direction) ? in_a_row + 1 : 0;
    count += in_a_row == 2 ? 2 : in_a_row > 2 ? 1 : 0;
  }
  return count;
}

}  // namespace

bool isMostlyOpen(const Scan& scan) {
  return scan.no_return_bearing.size() > scan.range.size();
}

Eigen::ArrayXd missedWalls(const Scan& scan, const Particles& particles,
                           const DistanceField& field) {
  constexpr double kRobot = 0.4;  // m, from the laser: no wall can be there, though the map has one
  Eigen::ArrayXd missed = Eigen::ArrayXd::Zero(particles.size());
  const Eigen::Index beams = scan.no_return_bearing.size();
  if (beams == 0 || particles.size() == 0) return missed;
  const auto directions = directionsOf(scan, strideFor(beams, particles.size()));
  const double weight = static_cast<double>(beams) / static_cast<double>(directions.size());
  const double cells_per_metre = 1.0 / field.lattice().resolution();
  const double from = kRobot * cells_per_metre;
  const double until = (0.9 * scan.max_range - 0.2) * cells_per_metre;
  parallelFor(static_cast<std::size_t>(particles.size()), kChunk, [&](const Chunk& chunk) {
    for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      const Transform2 to_lattice(field.lattice().toLattice(particles.pose(i)));
      const Eigen::Vector2d origin = to_lattice * Eigen::Vector2d(0.0, 0.0);
      const Eigen::Vector2d start = cells_per_metre * (to_lattice * scan.position);
      missed[i] = weight * sideBySide(directions, [&](const Eigen::Vector2d& direction) {
                    return meetsWall(field, start, to_lattice * direction - origin, from, until);
                  });
    }
  });
  return missed;
}

}  // namespace adaptive_localization
