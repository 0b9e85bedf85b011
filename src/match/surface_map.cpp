// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/match/surface_map.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace adaptive_localization {
namespace {

constexpr int kReach = 3;           // cells round about that a line is fitted to
constexpr double kSpread = 1.5;     // cells, of the weights
constexpr int kLeastCells = 3;      // that make a line
constexpr double kRoughness = 0.4;  // variance across a line against that along it
constexpr float kHalfCells = 1.0F;  // half the length of a piece of wall
constexpr double kThinWall = 0.1;   // m
constexpr double kBeyond = 2.0;     // m that labels reach beyond all surfaces

/// Occupied, and free ground touches it: what a laser sees of a wall that is several cells thick.
bool isVisible(const OccupancyGrid& grid, const Cell& c) {
  if (!grid.isOccupied(c)) return false;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (grid.isFree({c.x + dx, c.y + dy})) return true;
    }
  }
  return false;
}

/// From which side a cell is seen: 0 not at all, 1 to 16 the direction of the free ground around,
/// or both sides.
using Side = std::uint8_t;
constexpr int kSides = 16;
constexpr Side kBothSides = 255;

Side sideOf(const OccupancyGrid& grid, const Cell& c) {
  if (!isVisible(grid, c)) return 0;
  Eigen::Vector2d sum(0.0, 0.0);
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      if (grid.isFree({c.x + dx, c.y + dy})) sum += Eigen::Vector2d(dx, dy).normalized();
    }
  }
  if (sum.norm() < 1.0) return kBothSides;
  const double turns = std::atan2(sum.y(), sum.x()) / (2.0 * kPi);
  const auto side = static_cast<int>(std::lround((turns + 1.0) * kSides));
  return static_cast<Side>(1 + side % kSides);
}

/// Less than a right angle apart.
bool areOfOneSide(Side a, Side b) {
  if (a == 0 || b == 0) return false;
  if (a == kBothSides || b == kBothSides) return true;
  const int apart = std::abs(a - b);
  return std::min(apart, kSides - apart) < kSides / 4;
}

/// Weighted mean and scatter of cells, in cells from the middle one.
struct Scatter {
  double weight{0.0};
  int count{0};
  Eigen::Vector2d sum{0.0, 0.0};
  Eigen::Matrix2d squares{Eigen::Matrix2d::Zero()};

  void add(const Eigen::Vector2d& at) {
    const double w = std::exp(-0.5 * at.squaredNorm() / (kSpread * kSpread));
    weight += w;
    ++count;
    sum += w * at;
    squares += w * at * at.transpose();
  }
  Eigen::Vector2d mean() const { return sum / weight; }
  Eigen::Matrix2d covariance() const { return squares / weight - mean() * mean().transpose(); }
};

/// How much free ground there is on the side of a direction.
int freeAlong(const OccupancyGrid& grid, const Cell& cell, const Eigen::Vector2d& direction) {
  int count = 0;
  for (int step = 1; step <= kReach; ++step) {
    const Eigen::Vector2d at = step * direction;
    count += grid.isFree({cell.x + static_cast<int>(std::lround(at.x())),
                          cell.y + static_cast<int>(std::lround(at.y()))});
  }
  return count;
}

class Fitter {
 public:
  Fitter(const OccupancyGrid& grid, const std::vector<Side>& sides) : grid_(grid), sides_(sides) {}

  /// The line through the cells around one; none where they make no line.
  std::optional<Surface> fit(const Cell& cell) const {
    const Scatter scatter = scatterAround(cell);
    if (scatter.count < kLeastCells) return std::nullopt;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(scatter.covariance());
    const Eigen::Vector2d across = solver.eigenvectors().col(0);
    if (solver.eigenvalues()[0] > kRoughness * solver.eigenvalues()[1]) return std::nullopt;
    const int left = freeAlong(grid_, cell, across);
    const int right = freeAlong(grid_, cell, -across);
    if (left + right == 0) return std::nullopt;
    const Eigen::Vector2d normal = right > left ? Eigen::Vector2d(-across) : across;
    const Eigen::Vector2d offset = across.dot(scatter.mean()) * across;  // of the line's foot
    const Lattice& lattice = grid_.lattice();
    const double turn = lattice.origin().theta;
    const Pose2 to_map{0.0, 0.0, turn};
    const Eigen::Vector2d point = lattice.centre(cell) + to_map * (lattice.resolution() * offset);
    return Surface{point.cast<float>(), (to_map * normal).cast<float>(),
                   kHalfCells * static_cast<float>(lattice.resolution()), left > 0 && right > 0};
  }

 private:
  Scatter scatterAround(const Cell& cell) const {
    Scatter scatter;
    const Side side = sides_[grid_.lattice().index(cell)];
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const Cell other{cell.x + dx, cell.y + dy};
        if (!grid_.lattice().contains(other)) continue;
        if (areOfOneSide(side, sides_[grid_.lattice().index(other)])) scatter.add({dx, dy});
      }
    }
    return scatter;
  }

  const OccupancyGrid& grid_;
  const std::vector<Side>& sides_;
};

}  // namespace

SurfaceMap::SurfaceMap(const OccupancyGrid& grid) : lattice_(grid.lattice()) {
  std::vector<Side> sides(lattice_.size());
  std::vector<Cell> visible;
  for (int y = 0; y < lattice_.height(); ++y) {
    for (int x = 0; x < lattice_.width(); ++x) {
      const Side side = sideOf(grid, {x, y});
      sides[lattice_.index({x, y})] = side;
      if (side > 0) visible.push_back({x, y});
    }
  }
  const Fitter fitter(grid, sides);
  std::vector<Seed> seeds;
  for (const Cell& cell : visible) {
    const auto surface = fitter.fit(cell);
    if (!surface) continue;
    seeds.push_back({cell, static_cast<std::uint32_t>(surfaces_.size())});
    surfaces_.push_back(*surface);
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
    const int steps = static_cast<int>(std::ceil(2.0 * length / lattice_.resolution()));
    for (int k = 0; k <= steps; ++k) {
      const Cell cell = lattice_.cellAt(segment.a + along * (static_cast<double>(k) / steps));
      if (lattice_.contains(cell)) seeds.push_back({cell, index});
    }
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
  const Surface* surface = nearest(hit);
  if (!surface || surface->faces(start)) return surface;
  const Eigen::Vector2d back = start - hit;
  surface = nearest(hit + back * std::min(1.0, kThinWall / back.norm()));
  return surface && surface->faces(start) ? surface : nullptr;
}

/// Each cell takes the label of the seed nearest to it (OpenCV's 5 x 5 chamfer distance).
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
  const auto* label = nearest.ptr<std::int32_t>();
  labels_.resize(nearest.total());
  for (std::uint32_t& surface : labels_) surface = surface_of[static_cast<std::size_t>(*label++)];
}

}  // namespace adaptive_localization
