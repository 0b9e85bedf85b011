// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/match/surface_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "cells_along.hpp"
#include "surface_fit.hpp"

namespace adaptive_localization {
namespace {

constexpr double kBeyond = 2.0;  // m that labels reach beyond all surfaces

/// Metres from a point to the nearest one of a surface.
double distanceOf(const Surface& surface, const Eigen::Vector2d& point) {
  const Eigen::Vector2d normal = surface.normal.cast<double>();
  const Eigen::Vector2d off = point - surface.point.cast<double>();
  const double along = std::abs(normal.x() * off.y() - normal.y() * off.x());
  const double beyond = std::max(0.0, along - static_cast<double>(surface.half_length));
  return std::hypot(normal.dot(off), beyond);
}

/// Layers are +x, -x, +y, -y.
bool looksTo(std::size_t layer, const Surface& surface) {
  const float part = surface.normal[static_cast<Eigen::Index>(layer / 2)];
  const float to = layer % 2 == 0 ? part : -part;
  return (surface.has_two_sides ? std::abs(part) : to) > 1e-3F;
}

}  // namespace

SurfaceMap::SurfaceMap(const OccupancyGrid& grid) : lattice_(grid.lattice()) {
  std::vector<Seed> seeds;
  for (const FittedSurface& fitted : fitSurfaces(grid)) {
    seeds.push_back({fitted.cell, static_cast<std::uint32_t>(surfaces_.size())});
    surfaces_.push_back(fitted.surface);
  }
  spread(seeds);
}

SurfaceMap::SurfaceMap(const Lattice& lattice, const std::vector<Segment>& segments)
    : lattice_(lattice) {
  std::vector<Seed> seeds;
  for (const Segment& segment : segments) {
    const Eigen::Vector2d along = segment.b - segment.a;
    const double length = along.norm();
    if (!(length > 0.0)) continue;
    const auto index = static_cast<std::uint32_t>(surfaces_.size());
    const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()) / length;
    surfaces_.push_back({(0.5 * (segment.a + segment.b)).cast<float>(), normal.cast<float>(),
                         static_cast<float>(0.5 * length), false});
    forEachCellAlong(lattice_, segment, [&](const Cell& cell) { seeds.push_back({cell, index}); });
  }
  const auto way = [&](const Seed& seed) {  // the last in a cell is the one that counts
    const Surface& surface = surfaces_[seed.surface];
    const Eigen::Vector2d off = lattice_.centre(seed.cell) - surface.point.cast<double>();
    return std::abs(off.dot(surface.normal.cast<double>()));
  };
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](const Seed& a, const Seed& b) { return way(a) > way(b); });
  spread(seeds);
}

const Surface* SurfaceMap::hitBy(const Eigen::Vector2d& start, const Eigen::Vector2d& hit) const {
  const Cell cell = lattice_.cellAt(hit);
  const auto column = static_cast<std::int64_t>(cell.x) - first_.x;
  const auto row = static_cast<std::int64_t>(cell.y) - first_.y;
  if (column < 0 || column >= width_ || row < 0 || row >= height_) return nullptr;
  const std::size_t at = kLayers * static_cast<std::size_t>(row * width_ + column);
  const Surface* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t layer : {start.x() > hit.x() ? 0U : 1U, start.y() > hit.y() ? 2U : 3U}) {
    const std::uint32_t label = labelAt(at + layer);
    if (label >= surfaces_.size()) continue;
    const Surface& surface = surfaces_[label];
    const double way = distanceOf(surface, hit);
    if (!surface.faces(start) || !(way < least)) continue;
    best = &surface;
    least = way;
  }
  return best;
}

void SurfaceMap::spread(const std::vector<Seed>& seeds) {
  if (seeds.empty()) return;
  const int beyond = static_cast<int>(std::ceil(kBeyond / lattice_.resolution()));
  Cell low = seeds.front().cell, high = low;
  for (const Seed& seed : seeds) {
    low = {std::min(low.x, seed.cell.x), std::min(low.y, seed.cell.y)};
    high = {std::max(high.x, seed.cell.x), std::max(high.y, seed.cell.y)};
  }
  first_ = {std::max(0, low.x - beyond), std::max(0, low.y - beyond)};
  width_ = std::min(lattice_.width(), high.x + beyond + 1) - first_.x;
  height_ = std::min(lattice_.height(), high.y + beyond + 1) - first_.y;
  const std::size_t size =
      kLayers * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  const std::size_t none = surfaces_.size();
  if (none <= std::numeric_limits<std::uint16_t>::max()) {
    labels_.assign(size, static_cast<std::uint16_t>(none));
  } else {
    wide_labels_.assign(size, static_cast<std::uint32_t>(none));
  }
  for (std::size_t layer = 0; layer < kLayers; ++layer) {
    std::vector<Seed> some;
    for (const Seed& seed : seeds) {
      if (looksTo(layer, surfaces_[seed.surface])) some.push_back(seed);
    }
    if (!some.empty()) label(layer, some);
  }
}

/// Each cell takes the label of the seed nearest to it (OpenCV's 5 x 5 chamfer distance).
void SurfaceMap::label(std::size_t layer, const std::vector<Seed>& seeds) {
  cv::Mat is_empty(height_, width_, CV_8U, cv::Scalar(255)), distances, nearest;
  for (const Seed& seed : seeds) {
    is_empty.at<std::uint8_t>(seed.cell.y - first_.y, seed.cell.x - first_.x) = 0;
  }
  cv::distanceTransform(is_empty, distances, nearest, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
  std::vector<std::uint32_t> surface_of(seeds.size() + 1);  // OpenCV's labels start at 1
  for (const Seed& seed : seeds) {
    const auto label = nearest.at<std::int32_t>(seed.cell.y - first_.y, seed.cell.x - first_.x);
    surface_of[static_cast<std::size_t>(label)] = seed.surface;
  }
  const auto* seed = nearest.ptr<std::int32_t>();
  for (std::size_t at = layer; at < kLayers * nearest.total(); at += kLayers) {
    const std::uint32_t surface = surface_of[static_cast<std::size_t>(*seed++)];
    if (wide_labels_.empty()) {
      labels_[at] = static_cast<std::uint16_t>(surface);
    } else {
      wide_labels_[at] = surface;
    }
  }
}

}  // namespace adaptive_localization
