// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/map/lattice.hpp"
#include "map/polygon.hpp"

namespace adaptive_localization {

/// Segments sorted into square bins, so that a ray or a disc meets only the near ones.
class SegmentIndex {
 public:
  /// Takes at least one segment.
  explicit SegmentIndex(std::vector<Segment> segments);

  /// Metres from the ray's start to the first segment, max_range if there is none before.
  double range(const Pose2& ray, double max_range) const;

  /// Metres from a point to the nearest segment, cap if all are farther.
  double distance(const Eigen::Vector2d& point, double cap) const;

 private:
  double nearestHit(const std::vector<int>& candidates, const Eigen::Vector2d& start,
                    const Eigen::Vector2d& direction) const;

  std::vector<Segment> segments_;
  std::vector<int> all_;
  Lattice lattice_;
  std::vector<std::vector<int>> bins_;
};

}  // namespace adaptive_localization
