// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// Where to look for a robot that may be anywhere.
class PoseSampler {
 public:
  virtual ~PoseSampler() = default;

  /// Takes note of what was observed, for samplers whose region depends on it, and tells whether
  /// they draw from such a region now. If not, they draw from all free space: nothing was observed,
  /// nothing of that kind is in the map, or what is needed to know is still being made.
  virtual bool condition(const Observations&) { return false; }

  /// A pose of base in map.
  virtual Pose2 draw(Rng& rng) const = 0;
};

/// Uniform over the free cells of a map, inside of each cell, and over all headings.
class FreeSpaceSampler : public PoseSampler {
 public:
  /// Throws std::invalid_argument if the map has no free cell.
  explicit FreeSpaceSampler(std::shared_ptr<const OccupancyGrid> map);

  Pose2 draw(Rng& rng) const override;

 private:
  std::shared_ptr<const OccupancyGrid> map_;
  std::vector<std::uint32_t> free_before_row_;  // free cells in the rows before each
};

}  // namespace adaptive_localization
