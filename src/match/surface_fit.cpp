// SPDX-License-Identifier: BSD-3-Clause
#include "surface_fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "adaptive_localization/map/sparse_grid.hpp"

namespace adaptive_localization {
namespace {

constexpr int kReach = 3;           // cells round about that a line is fitted to
constexpr double kSpread = 1.5;     // cells, of the weights
constexpr int kLeastCells = 3;      // that make a line
constexpr double kRoughness = 0.4;  // variance across a line against that along it
constexpr float kHalfCells = 1.0F;  // half the length of a piece of wall

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

Eigen::Vector2d directionOf(Side side) {
  const double angle = 2.0 * kPi * (side - 1) / kSides;
  return {std::cos(angle), std::sin(angle)};
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

class Fitter {
 public:
  Fitter(const OccupancyGrid& grid, const SparseGrid& sides) : grid_(grid), sides_(sides) {}

  /// The line through the cells around one; none where they make no line.
  std::optional<Surface> fit(const Cell& cell) const {
    const Scatter scatter = scatterAround(cell);
    if (scatter.count < kLeastCells) return std::nullopt;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(scatter.covariance());
    const Eigen::Vector2d across = solver.eigenvectors().col(0);
    if (solver.eigenvalues()[0] > kRoughness * solver.eigenvalues()[1]) return std::nullopt;
    const Side side = sideAt(cell);
    const double towards = across.dot(directionOf(side));
    const Eigen::Vector2d normal = towards < 0.0 ? Eigen::Vector2d(-across) : across;
    const Eigen::Vector2d offset = across.dot(scatter.mean()) * across;  // of the line's foot
    const Lattice& lattice = grid_.lattice();
    const double turn = lattice.origin().theta;
    const Pose2 to_map{0.0, 0.0, turn};
    const Eigen::Vector2d point = lattice.centre(cell) + to_map * (lattice.resolution() * offset);
    return Surface{point, (to_map * normal).cast<float>(),
                   kHalfCells * static_cast<float>(lattice.resolution()), side == kBothSides};
  }

 private:
  Scatter scatterAround(const Cell& cell) const {
    Scatter scatter;
    const Side side = sideAt(cell);
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const Cell other{cell.x + dx, cell.y + dy};
        if (!grid_.lattice().contains(other)) continue;
        if (areOfOneSide(side, sideAt(other))) scatter.add({dx, dy});
      }
    }
    return scatter;
  }

  Side sideAt(const Cell& cell) const { return static_cast<Side>(sides_.at(cell.x, cell.y)); }

  const OccupancyGrid& grid_;
  const SparseGrid& sides_;
};

}  // namespace

std::vector<FittedSurface> fitSurfaces(const OccupancyGrid& grid) {
  const Lattice& lattice = grid.lattice();
  SparseGrid sides(lattice.width(), lattice.height());
  std::vector<Cell> visible;
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      const Side side = sideOf(grid, {x, y});
      if (side == 0) continue;
      sides.set(x, y, side);
      visible.push_back({x, y});
    }
  }
  const Fitter fitter(grid, sides);
  std::vector<FittedSurface> fitted;
  for (const Cell& cell : visible) {
    if (const auto surface = fitter.fit(cell)) fitted.push_back({cell, *surface});
  }
  return fitted;
}

}  // namespace adaptive_localization
