// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace adaptive_localization {

/// Corners in order, metres; the last is joined to the first.
using Polygon = std::vector<Eigen::Vector2d>;

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

struct Segment {
  Eigen::Vector2d a;
  Eigen::Vector2d b;
};

/// An upright rectangle, metres.
struct Bounds {
  Eigen::Vector2d low;
  Eigen::Vector2d high;

  bool contains(const Eigen::Vector2d& point) const {
    return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
  }
};

/// Of at least one corner.
Bounds boundsOf(const Polygon& polygon);

/// Whether a point lies within (crossing number; points on an edge may fall on either side).
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

/// Calls action(Segment) for every side.
template <class Action>
void forEachSide(const Polygon& polygon, Action&& action) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    action(Segment{polygon[i], polygon[(i + 1) % polygon.size()]});
  }
}

/// The rectangle around a segment, lengthened by half the thickness at both ends, so that
/// walls meet without a notch.
Polygon thickLine(const Segment& centre, double thickness);

/// Metres from a point to the nearest point of a segment.
double distance(const Segment& segment, const Eigen::Vector2d& point);

/// Metres along a ray (unit direction) to a segment, infinity if it misses it.
double hit(const Segment& segment, const Eigen::Vector2d& start, const Eigen::Vector2d& direction);

}  // namespace adaptive_localization
