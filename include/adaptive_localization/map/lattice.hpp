// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Column and row of a cell; may lie outside the lattice.
struct Cell {
  int x;
  int y;
};

/// How cells relate to metres, and the only place that knows. Cell (0, 0) has its corner, not its
/// centre, at the origin, as nav_msgs/OccupancyGrid says; the origin may be rotated.
///
/// "Lattice coordinates" are metres in the lattice's own frame, in the map frame if the origin is
/// zero: T_map_lattice = origin.
class Lattice {
 public:
  /// Throws std::invalid_argument unless width and height are at least 1 and, rounded up to
  /// multiples of 64 with a border, at most 2147483647 cells together, the resolution is from a
  /// millimetre to 100 km and the origin is finite and within 1e8 m.
  Lattice(int width, int height, double resolution, const Pose2& origin);

  int width() const { return width_; }
  int height() const { return height_; }
  double resolution() const { return resolution_; }  // metres per cell
  const Pose2& origin() const { return origin_; }    // T_map_lattice
  std::size_t size() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }

  bool contains(const Cell& cell) const {
    return cell.x >= 0 && cell.x < width_ && cell.y >= 0 && cell.y < height_;
  }
  /// Row-major index of a cell that the lattice contains.
  std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }
  Cell cell(std::size_t index) const {
    const auto width = static_cast<std::size_t>(width_);
    return {static_cast<int>(index % width), static_cast<int>(index / width)};
  }

  /// The cell around a point given in the map frame; may lie outside.
  Cell cellAt(const Eigen::Vector2d& point_map) const;

  /// Centre of a cell in the map frame.
  Eigen::Vector2d centre(const Cell& cell) const;

  /// A point or a pose in the map frame, expressed in lattice coordinates.
  Eigen::Vector2d toLattice(const Eigen::Vector2d& point_map) const {
    return to_lattice_ * point_map;
  }
  Pose2 toLattice(const Pose2& T_map_x) const {
    const Eigen::Vector2d point = toLattice(Eigen::Vector2d(T_map_x.x, T_map_x.y));
    return {point.x(), point.y(), wrapAngle(T_map_x.theta - origin_.theta)};
  }

  bool operator==(const Lattice& other) const;

 private:
  int width_;
  int height_;
  double resolution_;
  Pose2 origin_;
  Transform2 to_lattice_;
};

}  // namespace adaptive_localization
