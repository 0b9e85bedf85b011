// SPDX-License-Identifier: BSD-3-Clause
#include "map/polygon.hpp"

#include <algorithm>
#include <limits>

namespace adaptive_localization {

Bounds boundsOf(const Polygon& polygon) {
  Bounds bounds{polygon.front(), polygon.front()};
  for (const auto& corner : polygon) {
    bounds.low = bounds.low.cwiseMin(corner);
    bounds.high = bounds.high.cwiseMax(corner);
  }
  return bounds;
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& point) {
  bool inside = false;
  forEachSide(polygon, [&](const Segment& side) {
    if ((side.a.y() > point.y()) == (side.b.y() > point.y())) return;
    const double share = (point.y() - side.a.y()) / (side.b.y() - side.a.y());
    if (point.x() < side.a.x() + share * (side.b.x() - side.a.x())) inside = !inside;
  });
  return inside;
}

Polygon thickLine(const Segment& centre, double thickness) {
  const Eigen::Vector2d along = (centre.b - centre.a).normalized() * (thickness / 2.0);
  const Eigen::Vector2d across(-along.y(), along.x());
  return {centre.a - along - across, centre.b + along - across, centre.b + along + across,
          centre.a - along + across};
}

double distance(const Segment& segment, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = segment.b - segment.a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? along.dot(point - segment.a) / length2 : 0.0;
  return (segment.a + std::min(std::max(share, 0.0), 1.0) * along - point).norm();
}

double hit(const Segment& segment, const Eigen::Vector2d& start, const Eigen::Vector2d& direction) {
  constexpr double kMiss = std::numeric_limits<double>::infinity();
  constexpr double kSlack = 1e-9;  // of a side's length, so that no ray slips through a corner
  const Eigen::Vector2d along = segment.b - segment.a;
  const double turn = cross(direction, along);
  if (turn == 0.0) return kMiss;  // parallel: the sides that it ends on are hit instead
  const Eigen::Vector2d to_a = segment.a - start;
  const double range = cross(to_a, along) / turn;
  const double share = cross(to_a, direction) / turn;
  return range >= 0.0 && share >= -kSlack && share <= 1.0 + kSlack ? range : kMiss;
}

}  // namespace adaptive_localization
