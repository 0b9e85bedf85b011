// SPDX-License-Identifier: BSD-3-Clause
#include "sim/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>

namespace adaptive_localization {
namespace {

constexpr double kCell = 0.05;     // m
constexpr double kComfort = 0.25;  // m of room beside the disc that a way should keep
constexpr float kNotFree = -1.0F;
constexpr std::array<Cell, 8> kSteps{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

Lattice latticeOver(const Bounds& bounds) {
  const Eigen::Vector2d size = (bounds.high - bounds.low) / kCell;
  if (!(size.x() * size.y() < 1e8)) {
    throw std::invalid_argument("world: expected one of less than 1e8 cells of 0.05 m");
  }
  return {static_cast<int>(size.x()) + 1,
          static_cast<int>(size.y()) + 1,
          kCell,
          {bounds.low.x(), bounds.low.y(), 0.0}};
}

struct Candidate {
  double estimate;  // of the whole way's cost
  std::size_t index;
  bool operator<(const Candidate& other) const { return estimate > other.estimate; }
};

}  // namespace

FreeSpace::FreeSpace(std::shared_ptr<const World> world, double radius)
    : world_(std::move(world)), radius_(radius), lattice_(latticeOver(world_->bounds())) {
  clearance_.resize(lattice_.size());
  for (std::size_t i = 0; i < clearance_.size(); ++i) {
    const Eigen::Vector2d centre = lattice_.centre(lattice_.cell(i));
    const double room = world_->clearance(centre, radius + kComfort);
    clearance_[i] = room >= radius ? static_cast<float>(room - radius) : kNotFree;
  }
  keepLargestPart();
  if (cells_.empty()) {
    throw std::invalid_argument("world: expected free space for a robot of radius " +
                                std::to_string(radius) + " m, found none");
  }
}

void FreeSpace::keepLargestPart() {
  std::vector<char> seen(clearance_.size(), 0);
  for (std::size_t seed = 0; seed < clearance_.size(); ++seed) {
    if (seen[seed] || clearance_[seed] < 0.0F) continue;
    std::vector<std::size_t> part{seed};
    seen[seed] = 1;
    for (std::size_t next = 0; next < part.size(); ++next) {
      const Cell cell = lattice_.cell(part[next]);
      for (std::size_t k = 0; k < 4; ++k) {
        const Cell neighbour{cell.x + kSteps[k].x, cell.y + kSteps[k].y};
        if (!lattice_.contains(neighbour)) continue;
        const std::size_t index = lattice_.index(neighbour);
        if (seen[index] || clearance_[index] < 0.0F) continue;
        seen[index] = 1;
        part.push_back(index);
      }
    }
    if (part.size() > cells_.size()) cells_ = std::move(part);
  }
  std::sort(cells_.begin(), cells_.end());
  std::vector<float> kept(clearance_.size(), kNotFree);
  for (const std::size_t index : cells_) kept[index] = clearance_[index];
  clearance_ = std::move(kept);
}

bool FreeSpace::contains(const Eigen::Vector2d& point) const {
  const Cell cell = lattice_.cellAt(point);
  return lattice_.contains(cell) && clearance_[lattice_.index(cell)] >= 0.0F;
}

Eigen::Vector2d FreeSpace::nearest(const Eigen::Vector2d& point) const {
  if (contains(point)) return point;
  const auto squared = [&](std::size_t index) {
    return (lattice_.centre(lattice_.cell(index)) - point).squaredNorm();
  };
  const auto best = std::min_element(cells_.begin(), cells_.end(),
                                     [&](auto a, auto b) { return squared(a) < squared(b); });
  return lattice_.centre(lattice_.cell(*best));
}

Eigen::Vector2d FreeSpace::sample(Rng& rng) const {
  return lattice_.centre(lattice_.cell(cells_[rng.below(cells_.size())]));
}

bool FreeSpace::isFree(const Segment& line, double margin) const {
  const double needed = radius_ + margin;
  const int steps = static_cast<int>(std::ceil((line.b - line.a).norm() / kCell)) + 1;
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2d point = line.a + (line.b - line.a) * (static_cast<double>(i) / steps);
    if (world_->clearance(point, needed) < needed) return false;
  }
  return true;
}

std::vector<Eigen::Vector2d> FreeSpace::path(const Eigen::Vector2d& from,
                                             const Eigen::Vector2d& to) const {
  const std::size_t start = lattice_.index(lattice_.cellAt(nearest(from)));
  const std::size_t goal = lattice_.index(lattice_.cellAt(nearest(to)));
  const Eigen::Vector2d end = lattice_.centre(lattice_.cell(goal));
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  std::vector<double> cost(clearance_.size(), kUnknown);
  std::vector<std::size_t> before(clearance_.size(), start);
  std::priority_queue<Candidate> queue;
  cost[start] = 0.0;
  queue.push({0.0, start});
  while (!queue.empty() && queue.top().index != goal) {
    const std::size_t index = queue.top().index;
    queue.pop();
    const Cell cell = lattice_.cell(index);
    for (const auto& step : kSteps) {
      const Cell neighbour{cell.x + step.x, cell.y + step.y};
      if (!lattice_.contains(neighbour)) continue;
      const std::size_t next = lattice_.index(neighbour);
      if (clearance_[next] < 0.0F) continue;
      const double tight = 1.0 - clearance_[next] / kComfort;  // 0 with room enough, 1 at the wall
      const double price = cost[index] + kCell * std::hypot(step.x, step.y) * (1.0 + 4.0 * tight);
      if (price >= cost[next]) continue;
      cost[next] = price;
      before[next] = index;
      queue.push({price + (lattice_.centre(neighbour) - end).norm(), next});
    }
  }
  std::vector<Eigen::Vector2d> way{end};
  for (std::size_t i = goal; i != start; i = before[i]) {
    way.push_back(lattice_.centre(lattice_.cell(before[i])));
  }
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace adaptive_localization
