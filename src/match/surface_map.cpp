// SPDX-License-Identifier: BSD-3-Clause
#include "match/surface_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "cells_along.hpp"
#include "core/parallel.hpp"
#include "surface_fit.hpp"

namespace adaptive_localization {
namespace {

constexpr int kTilesPerGroup = 8;  // along x and y, that are labelled together
constexpr int kMostReach = 1000;   // cells

/// Metres from a point to the nearest one of a surface.
double distanceOf(const Surface& surface, const Eigen::Vector2d& point) {
  const Eigen::Vector2d normal = surface.normal.cast<double>();
  const Eigen::Vector2d off = point - surface.point;
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

SurfaceMap::SurfaceMap(const OccupancyGrid& grid, double reach) : lattice_(grid.lattice()) {
  std::vector<Seed> seeds;
  for (const FittedSurface& fitted : fitSurfaces(grid)) {
    seeds.push_back({fitted.cell, static_cast<std::uint32_t>(surfaces_.size())});
    surfaces_.push_back(fitted.surface);
  }
  spread(seeds, reach);
}

SurfaceMap::SurfaceMap(const Lattice& lattice, const std::vector<Segment>& segments, double reach)
    : lattice_(lattice) {
  std::vector<Seed> seeds;
  for (const Segment& segment : segments) {
    const Eigen::Vector2d along = segment.b - segment.a;
    const double length = along.norm();
    if (!(length > 0.0)) continue;
    const auto index = static_cast<std::uint32_t>(surfaces_.size());
    const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()) / length;
    surfaces_.push_back({0.5 * (segment.a + segment.b), normal.cast<float>(),
                         static_cast<float>(0.5 * length), false});
    forEachCellAlong(lattice_, segment, [&](const Cell& cell) { seeds.push_back({cell, index}); });
  }
  const auto way = [&](const Seed& seed) {  // the last in a cell is the one that counts
    const Surface& surface = surfaces_[seed.surface];
    const Eigen::Vector2d off = lattice_.centre(seed.cell) - surface.point;
    return std::abs(off.dot(surface.normal.cast<double>()));
  };
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](const Seed& a, const Seed& b) { return way(a) > way(b); });
  spread(seeds, reach);
}

const Surface* SurfaceMap::hitBy(const Eigen::Vector2d& start, const Eigen::Vector2d& hit) const {
  const Cell cell = lattice_.cellAt(hit);
  if (tiles_.empty() || !lattice_.contains(cell)) return nullptr;
  const Tile& tile = tiles_[tileOf(cell)];
  if (tile.labels.empty()) return nullptr;
  const std::uint16_t* labels = &tile.labels[placeInTile(cell)];
  const Surface* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t layer : {start.x() > hit.x() ? 0U : 1U, start.y() > hit.y() ? 2U : 3U}) {
    if (labels[layer] == kNone) continue;
    const Surface& surface = surfaces_[tile.surfaces[labels[layer]]];
    const double way = distanceOf(surface, hit);
    if (!surface.faces(start) || !(way < least)) continue;
    best = &surface;
    least = way;
  }
  return best;
}

/// Some tiles that are labelled together.
class SurfaceMap::Group {
 public:
  /// Reach is in cells.
  Group(SurfaceMap& map, const std::vector<Seed>& seeds, int reach)
      : map_(map),
        lattice_(0, 0, map.lattice_.width(), map.lattice_.height()),
        seeds_(seeds),
        reach_(reach),
        number_of_(map.surfaces_.size(), kNone) {}

  /// From the first tile on, in columns and rows of tiles.
  void label(const Cell& first) {
    constexpr int kSide = kTile * kTilesPerGroup;
    const cv::Rect with_reach(first.x * kTile - reach_, first.y * kTile - reach_,
                              kSide + 2 * reach_, kSide + 2 * reach_);
    const cv::Rect box = with_reach & lattice_;
    for (std::size_t layer = 0; layer < kLayers; ++layer) findNearest(layer, box);
    for (int row = first.y; row < std::min(map_.rows_, first.y + kTilesPerGroup); ++row) {
      for (int x = first.x; x < std::min(map_.columns_, first.x + kTilesPerGroup); ++x) {
        const cv::Rect cells = cv::Rect(x * kTile, row * kTile, kTile, kTile) & lattice_;
        labelTile(map_.tiles_[map_.tileOf({cells.x, cells.y})], cells - box.tl());
      }
    }
  }

 private:
  /// In each cell of a box the surface of the seed nearest to it (OpenCV's 5 x 5 chamfer distance);
  /// -1: none within reach.
  void findNearest(std::size_t layer, const cv::Rect& box) {
    cv::Mat is_empty(box.size(), CV_8U, cv::Scalar(255)), distances;
    std::vector<Seed> looking;
    for (const Seed& seed : seeds_) {
      if (!looksTo(layer, map_.surfaces_[seed.surface])) continue;
      looking.push_back({{seed.cell.x - box.x, seed.cell.y - box.y}, seed.surface});
      is_empty.at<std::uint8_t>(looking.back().cell.y, looking.back().cell.x) = 0;
    }
    cv::Mat& nearest = nearest_[layer];
    nearest = cv::Mat(box.size(), CV_32S, cv::Scalar(-1));
    if (looking.empty()) return;
    cv::distanceTransform(is_empty, distances, nearest, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
    std::vector<std::int32_t> surface_of(looking.size() + 1);  // OpenCV's labels start at 1
    for (const Seed& seed : looking) {
      const auto label = nearest.at<std::int32_t>(seed.cell.y, seed.cell.x);
      surface_of[static_cast<std::size_t>(label)] = static_cast<std::int32_t>(seed.surface);
    }
    const auto* distance = distances.ptr<float>();
    const auto end = nearest.end<std::int32_t>();
    for (auto label = nearest.begin<std::int32_t>(); label != end; ++label) {
      const bool is_near = *distance++ <= static_cast<float>(reach_);
      *label = is_near ? surface_of[static_cast<std::size_t>(*label)] : -1;
    }
  }

  void labelTile(Tile& tile, const cv::Rect& cells) {
    for (int y = 0; y < cells.height; ++y) {
      for (int x = 0; x < cells.width; ++x) {
        for (std::size_t layer = 0; layer < kLayers; ++layer) {
          const auto surface = nearest_[layer].at<std::int32_t>(cells.y + y, cells.x + x);
          if (surface < 0) continue;
          if (tile.labels.empty()) tile.labels.assign(kLayers * kTile * kTile, kNone);
          const std::size_t at = placeInTile({x, y}) + layer;
          tile.labels[at] = numberOf(static_cast<std::uint32_t>(surface), tile);
        }
      }
    }
    for (const std::uint32_t surface : tile.surfaces) number_of_[surface] = kNone;
  }

  std::uint16_t numberOf(std::uint32_t surface, Tile& tile) {
    std::uint16_t& number = number_of_[surface];
    if (number == kNone) {
      number = static_cast<std::uint16_t>(tile.surfaces.size());
      tile.surfaces.push_back(surface);
    }
    return number;
  }

  SurfaceMap& map_;
  cv::Rect lattice_;
  const std::vector<Seed>& seeds_;
  int reach_;
  std::array<cv::Mat, kLayers> nearest_;
  std::vector<std::uint16_t> number_of_;  // of surfaces, in the list of the tile at hand
};

/// By groups of tiles, each with the seeds that are within its reach.
void SurfaceMap::spread(const std::vector<Seed>& seeds, double reach) {
  if (seeds.empty()) return;
  constexpr int kSide = kTile * kTilesPerGroup;  // cells
  const auto number = [](int cells, int of) { return (cells + of - 1) / of; };
  const int cells = static_cast<int>(
      std::min(std::ceil(reach / lattice_.resolution()), static_cast<double>(kMostReach)));
  columns_ = number(lattice_.width(), kTile);
  rows_ = number(lattice_.height(), kTile);
  tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  const int across = number(lattice_.width(), kSide), down = number(lattice_.height(), kSide);
  std::vector<std::vector<Seed>> near(static_cast<std::size_t>(across) *
                                      static_cast<std::size_t>(down));
  for (const Seed& seed : seeds) {
    const int last_x = std::min(across - 1, (seed.cell.x + cells) / kSide);
    const int last_y = std::min(down - 1, (seed.cell.y + cells) / kSide);
    for (int y = std::max(0, seed.cell.y - cells) / kSide; y <= last_y; ++y) {
      for (int x = std::max(0, seed.cell.x - cells) / kSide; x <= last_x; ++x) {
        near[static_cast<std::size_t>(y * across + x)].push_back(seed);
      }
    }
  }
  parallelFor(near.size(), 1, [&](const Chunk& chunk) {
    const auto group = static_cast<int>(chunk.begin);
    if (near[chunk.begin].empty()) return;
    const Cell first{group % across * kTilesPerGroup, group / across * kTilesPerGroup};
    Group(*this, near[chunk.begin], cells).label(first);
  });
}

}  // namespace adaptive_localization
