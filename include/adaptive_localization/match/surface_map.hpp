// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "adaptive_localization/map/polygon.hpp"
#include "adaptive_localization/match/surface.hpp"

namespace adaptive_localization {

/// The surface nearest to any point, by look-up: labels for each cell of the map.
///
/// From an occupancy grid: a line is fitted to the cells around each occupied one that free ground
/// touches on the same side (total least squares, weights falling with distance), which tells where
/// the wall is to a fraction of a cell if it is straight; where the cells around make no line there
/// is no surface. From line segments: the segments.
class SurfaceMap {
 public:
  explicit SurfaceMap(const OccupancyGrid& grid);

  /// Segments with the free side on the left of a -> b, looked up in the cells of a lattice;
  /// those of no length are left out.
  SurfaceMap(const Lattice& lattice, const std::vector<Segment>& segments);

  const Lattice& lattice() const { return lattice_; }

  /// The surface that a beam from `start` hit at a point: of those that face the start the nearest,
  /// which is the near side of a wall wherever noise puts the hit. Null more than two metres beyond
  /// all surfaces, outside the lattice, and where all face away.
  const Surface* hitBy(const Eigen::Vector2d& start, const Eigen::Vector2d& hit) const;

  /// All of them.
  const std::vector<Surface>& surfaces() const { return surfaces_; }

 private:
  /// A surface and the cell that it is in.
  struct Seed {
    Cell cell;
    std::uint32_t surface;
  };
  static constexpr std::size_t kLayers = 4;

  void spread(const std::vector<Seed>& seeds);
  void label(std::size_t layer, const std::vector<Seed>& seeds);
  std::uint32_t labelAt(std::size_t at) const {
    return wide_labels_.empty() ? labels_[at] : wide_labels_[at];
  }

  Lattice lattice_;
  std::vector<Surface> surfaces_;
  Cell first_{0, 0};  // of the part of the lattice that has labels
  int width_{0}, height_{0};
  /// Indices of the nearest of the surfaces that look to +x, -x, +y and -y, cell by cell and
  /// row-major; one beyond the last surface: none does. Wide ones only where there are many.
  std::vector<std::uint16_t> labels_;
  std::vector<std::uint32_t> wide_labels_;
};

}  // namespace adaptive_localization
