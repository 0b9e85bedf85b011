// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace adaptive_localization {

/// A piece of a wall as a laser sees it, in the map frame.
struct Surface {
  Eigen::Vector2d point;   // in the middle of it, m: coordinates of the earth are large
  Eigen::Vector2f normal;  // of length 1, to the free side
  float half_length;       // m to both sides of the point
  bool has_two_sides;      // free on both, a thin wall

  /// Whether it can be seen from a point.
  bool faces(const Eigen::Vector2d& point_map) const {
    return has_two_sides || normal.cast<double>().dot(point_map - point) > 0.0;
  }
};

}  // namespace adaptive_localization
