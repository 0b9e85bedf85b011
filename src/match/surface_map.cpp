// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/match/surface_map.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace adaptive_localization {
namespace {

constexpr int kReach = 3;            // cells round about that a line is fitted to
constexpr double kSpread = 1.5;      // cells, of the weights
constexpr int kLeastCells = 3;       // that make a line
constexpr double kRoughness = 0.4;   // variance across a line against that along it
constexpr float kHalfCells = 1.0F;   // half the length of a piece of wall
constexpr double kLongestWay = 1e6;  // cells

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
  Fitter(const OccupancyGrid& grid, const std::vector<std::uint8_t>& is_surface)
      : grid_(grid), is_surface_(is_surface) {}

  /// The line through the cells around one; none where they make no line.
  std::optional<Surface> fit(const Cell& cell) const {
    const Scatter scatter = scatterAround(cell);
    if (scatter.count < kLeastCells) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter.covariance());
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
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const Cell other{cell.x + dx, cell.y + dy};
        if (!grid_.lattice().contains(other)) continue;
        if (is_surface_[grid_.lattice().index(other)]) scatter.add({dx, dy});
      }
    }
    return scatter;
  }

  const OccupancyGrid& grid_;
  const std::vector<std::uint8_t>& is_surface_;
};

}  // namespace

SurfaceMap::SurfaceMap(const OccupancyGrid& grid) : lattice_(grid.lattice()) {
  std::vector<std::uint8_t> is_surface(lattice_.size());
  for (std::size_t i = 0; i < lattice_.size(); ++i) {
    is_surface[i] = isVisible(grid, lattice_.cell(i)) ? 1 : 0;
  }
  const Fitter fitter(grid, is_surface);
  std::vector<std::int32_t> seeds(lattice_.size(), -1);
  for (std::size_t i = 0; i < lattice_.size(); ++i) {
    if (!is_surface[i]) continue;
    if (const auto surface = fitter.fit(lattice_.cell(i))) {
      seeds[i] = static_cast<std::int32_t>(surfaces_.size());
      surfaces_.push_back(*surface);
    }
  }
  spread(std::move(seeds));
}

SurfaceMap::SurfaceMap(const Lattice& lattice, const std::vector<Segment>& segments)
    : lattice_(lattice) {
  std::vector<std::int32_t> seeds(lattice_.size(), -1);
  std::vector<double> ways(lattice_.size(), kLongestWay);
  for (const Segment& segment : segments) {
    const Eigen::Vector2d along = segment.b - segment.a;
    const double length = along.norm();
    if (!(length > 0.0)) continue;
    const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()) / length;
    const auto label = static_cast<std::int32_t>(surfaces_.size());
    surfaces_.push_back({(0.5 * (segment.a + segment.b)).cast<float>(), normal.cast<float>(),
                         static_cast<float>(0.5 * length), false});
    const int steps = static_cast<int>(std::ceil(2.0 * length / lattice_.resolution()));
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector2d at = segment.a + along * (static_cast<double>(k) / steps);
      const Cell cell = lattice_.cellAt(at);
      if (!lattice_.contains(cell)) continue;
      const std::size_t i = lattice_.index(cell);
      const double way = distance(segment, lattice_.centre(cell));
      if (way >= ways[i]) continue;
      ways[i] = way;
      seeds[i] = label;
    }
  }
  spread(std::move(seeds));
}

/// Each cell takes the label of the seed nearest to it (OpenCV's 5 x 5 chamfer distance).
void SurfaceMap::spread(std::vector<std::int32_t> seeds) {
  if (surfaces_.empty()) return;
  cv::Mat is_empty(lattice_.height(), lattice_.width(), CV_8U);
  for (std::size_t i = 0; i < seeds.size(); ++i) is_empty.data[i] = seeds[i] < 0 ? 255 : 0;
  cv::Mat distances, nearest;
  cv::distanceTransform(is_empty, distances, nearest, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
  const auto* pixels = nearest.ptr<std::int32_t>();
  const auto count = static_cast<std::size_t>(*std::max_element(pixels, pixels + seeds.size()));
  std::vector<std::int32_t> seed_of(count + 1, -1);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (seeds[i] >= 0) seed_of[static_cast<std::size_t>(pixels[i])] = seeds[i];
  }
  labels_.resize(seeds.size());
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    labels_[i] = seed_of[static_cast<std::size_t>(pixels[i])];
  }
}

}  // namespace adaptive_localization
