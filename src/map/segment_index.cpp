// SPDX-License-Identifier: BSD-3-Clause
#include "map/segment_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace adaptive_localization {
namespace {

constexpr double kSmallestBin = 0.5;  // m
constexpr double kMostBins = 512.0;   // along the longer side

Lattice latticeAround(const std::vector<Segment>& segments) {
  Polygon ends;
  for (const auto& segment : segments) {
    ends.push_back(segment.a);
    ends.push_back(segment.b);
  }
  const Bounds bounds = boundsOf(ends);
  const Eigen::Vector2d extent = bounds.high - bounds.low;
  const double bin = std::max(kSmallestBin, extent.maxCoeff() / kMostBins);
  const Eigen::Vector2d size = extent / bin;
  return {static_cast<int>(size.x()) + 2,
          static_cast<int>(size.y()) + 2,
          bin,
          {bounds.low.x() - bin / 2.0, bounds.low.y() - bin / 2.0, 0.0}};
}

/// Distance along a ray to the next bin border of one axis, and from border to border.
struct Borders {
  Borders(double start, double direction, double bin)
      : step(direction < 0.0 ? -1 : 1), spacing(bin / std::abs(direction)) {
    const double low = std::floor(start / bin) * bin;
    if (direction != 0.0)
      next = (direction > 0.0 ? low + bin - start : start - low) * spacing / bin;
  }

  int step;
  double spacing;
  double next{std::numeric_limits<double>::infinity()};
};

}  // namespace

SegmentIndex::SegmentIndex(std::vector<Segment> segments)
    : segments_(std::move(segments)),
      all_(segments_.size()),
      lattice_(latticeAround(segments_)),
      bins_(lattice_.size()) {
  std::iota(all_.begin(), all_.end(), 0);
  for (const int i : all_) {
    const Segment& segment = segments_[static_cast<std::size_t>(i)];
    const Bounds bounds = boundsOf({segment.a, segment.b});
    const Cell low = lattice_.cellAt(bounds.low);
    const Cell high = lattice_.cellAt(bounds.high);
    for (Cell cell = low; cell.y <= high.y; ++cell.y) {
      for (cell.x = low.x; cell.x <= high.x; ++cell.x) bins_[lattice_.index(cell)].push_back(i);
    }
  }
}

double SegmentIndex::nearestHit(const std::vector<int>& candidates, const Eigen::Vector2d& start,
                                const Eigen::Vector2d& direction) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int i : candidates) {
    nearest = std::min(nearest, hit(segments_[static_cast<std::size_t>(i)], start, direction));
  }
  return nearest;
}

double SegmentIndex::range(const Pose2& ray, double max_range) const {
  const Eigen::Vector2d start(ray.x, ray.y);
  const Eigen::Vector2d direction(std::cos(ray.theta), std::sin(ray.theta));
  Cell cell = lattice_.cellAt(start);
  if (!lattice_.contains(cell)) return std::min(max_range, nearestHit(all_, start, direction));

  const Pose2 local = lattice_.toLattice(ray);
  Borders columns(local.x, direction.x(), lattice_.resolution());
  Borders rows(local.y, direction.y(), lattice_.resolution());
  double nearest = max_range;
  while (lattice_.contains(cell)) {
    nearest = std::min(nearest, nearestHit(bins_[lattice_.index(cell)], start, direction));
    const bool sideways = columns.next < rows.next;
    Borders& border = sideways ? columns : rows;
    if (nearest <= border.next) break;  // nothing in a later bin can be nearer
    (sideways ? cell.x : cell.y) += border.step;
    border.next += border.spacing;
  }
  return nearest;
}

double SegmentIndex::distance(const Eigen::Vector2d& point, double cap) const {
  const Cell low = lattice_.cellAt(point - Eigen::Vector2d::Constant(cap));
  const Cell high = lattice_.cellAt(point + Eigen::Vector2d::Constant(cap));
  double nearest = cap;
  for (int y = std::max(low.y, 0); y <= std::min(high.y, lattice_.height() - 1); ++y) {
    for (int x = std::max(low.x, 0); x <= std::min(high.x, lattice_.width() - 1); ++x) {
      for (const int i : bins_[lattice_.index({x, y})]) {
        nearest = std::min(nearest, adaptive_localization::distance(
                                        segments_[static_cast<std::size_t>(i)], point));
      }
    }
  }
  return nearest;
}

}  // namespace adaptive_localization
