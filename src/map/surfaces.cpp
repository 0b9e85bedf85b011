// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "map/floor_plan.hpp"

namespace adaptive_localization {
namespace {

constexpr double kSame = 1e-6;  // m, what lies nearer is taken for one place

/// Where another side meets this one, as shares of its length: a crossing, or, of a side that
/// runs along it, the ends.
void addCuts(const Segment& side, const Segment& other, std::vector<double>& cuts) {
  const Eigen::Vector2d along = side.b - side.a;
  const Eigen::Vector2d to_other = other.b - other.a;
  const double length = along.norm();
  const double turn = cross(along, to_other);
  if (std::abs(turn) > kSame * length * to_other.norm()) {
    const Eigen::Vector2d start = other.a - side.a;
    const double share = cross(start, along) / turn;  // of the other side
    const double slack = kSame / to_other.norm();
    if (share > -slack && share < 1.0 + slack) cuts.push_back(cross(start, to_other) / turn);
    return;
  }
  for (const auto& end : {other.a, other.b}) {
    if (std::abs(cross(along, end - side.a)) < kSame * length) {
      cuts.push_back(along.dot(end - side.a) / (length * length));
    }
  }
}

/// The cuts and both ends in order.
std::vector<double> cutsOf(const Segment& side, const std::vector<Segment>& sides) {
  std::vector<double> cuts{0.0, 1.0};
  for (const auto& other : sides) addCuts(side, other, cuts);
  for (double& cut : cuts) cut = std::min(std::max(cut, 0.0), 1.0);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/// Whether b continues or overlaps a on the same line, seen from the same side.
bool continues(const Segment& a, const Segment& b) {
  const Eigen::Vector2d along = (a.b - a.a).normalized();
  const auto share = [&](const Eigen::Vector2d& point) { return along.dot(point - a.a); };
  return along.dot(b.b - b.a) > 0.0 && std::abs(cross(along, b.a - a.a)) < kSame &&
         std::abs(cross(along, b.b - a.a)) < kSame && share(b.a) < share(a.b) + kSame &&
         share(b.b) > -kSame;
}

/// Joins it with those that it continues, so that a wall's face is one segment.
void add(Segment piece, std::vector<Segment>& surfaces) {
  for (std::size_t i = 0; i < surfaces.size();) {
    const Segment& other = surfaces[i];
    if (!continues(other, piece)) {
      ++i;
      continue;
    }
    const Eigen::Vector2d along = piece.b - piece.a;
    if (along.dot(other.a - piece.a) < 0.0) piece.a = other.a;
    if (along.dot(other.b - piece.b) > 0.0) piece.b = other.b;
    surfaces.erase(surfaces.begin() + static_cast<std::ptrdiff_t>(i));
    i = 0;  // longer now, it may reach one passed over
  }
  surfaces.push_back(piece);
}

}  // namespace

std::vector<Segment> surfacesOf(const FloorPlan& plan) {
  const std::vector<Polygon> solids = solidsOf(plan);
  std::vector<Segment> sides;
  const auto keep = [&](const Segment& side) {
    if ((side.b - side.a).norm() > kSame) sides.push_back(side);
  };
  forEachSide(plan.outline, keep);
  for (const auto& solid : solids) forEachSide(solid, keep);

  std::vector<Segment> surfaces;
  for (const auto& side : sides) {
    const Eigen::Vector2d along = side.b - side.a;
    const Eigen::Vector2d left = Eigen::Vector2d(-along.y(), along.x()).normalized() * kSame;
    const std::vector<double> cuts = cutsOf(side, sides);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const Segment piece{side.a + cuts[i - 1] * along, side.a + cuts[i] * along};
      if ((piece.b - piece.a).norm() < kSame) continue;
      const Eigen::Vector2d middle = (piece.a + piece.b) / 2.0;
      const bool left_free = isFree(plan.outline, solids, middle + left);
      if (left_free == isFree(plan.outline, solids, middle - left))
        continue;  // within a solid, or solid on both sides
      add(left_free ? piece : Segment{piece.b, piece.a}, surfaces);
    }
  }
  return surfaces;
}

}  // namespace adaptive_localization
