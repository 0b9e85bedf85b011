// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/map/lattice.hpp"
#include "sim/world.hpp"

namespace adaptive_localization {

/// Where a disc can stand and get to: the largest connected part of a world's free space, as cells
/// of 5 cm. Finds ways through it.
class FreeSpace {
 public:
  /// Throws std::invalid_argument when the world has no place for a disc of this radius.
  FreeSpace(std::shared_ptr<const World> world, double radius);

  bool contains(const Eigen::Vector2d& point) const;

  /// The point itself if it is free, else the centre of the nearest free cell.
  Eigen::Vector2d nearest(const Eigen::Vector2d& point) const;

  Eigen::Vector2d sample(Rng& rng) const;

  /// Whether the disc, `margin` metres larger, can move along the line.
  bool isFree(const Segment& line, double margin) const;

  /// A way from near one point to near another in steps of at most a cell's diagonal, that keeps
  /// half a metre from walls where it can (A* with a price on nearness).
  std::vector<Eigen::Vector2d> path(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

 private:
  void keepLargestPart();

  std::shared_ptr<const World> world_;
  double radius_;
  Lattice lattice_;
  std::vector<float>
      clearance_;  // per cell, m, at most kComfort; negative where the disc cannot be
  std::vector<std::size_t> cells_;  // indices of the free ones
};

}  // namespace adaptive_localization
