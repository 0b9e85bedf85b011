// SPDX-License-Identifier: BSD-3-Clause
#include "map/evidence_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace adaptive_localization {
namespace {

constexpr double kOccupied = 0.65, kFree = 0.35;  // probabilities above and below
constexpr double kShareOfRange = 0.01;            // standard deviation
constexpr double kReach = 3.0;                    // deviations behind an arc

/// Sources refuse what makes no sense; whoever builds a map may not.
bool isUsable(const Pose2& T_map_sonar, const SonarReading& reading) {
  return reading.range >= 0.0 && reading.max_range > 0.0 && std::isfinite(reading.max_range) &&
         reading.view > 0.0 && reading.view <= kPi && isFinite(T_map_sonar);
}

/// Cells of a box, both ends included.
struct Block {
  Cell low, high;
};

/// Around a cone that starts at a pose in lattice coordinates, cut to the lattice; nothing is left
/// of one outside (low > high).
Block blockAround(const Pose2& sonar, double reach, double view, const Lattice& lattice) {
  double left = sonar.x, right = sonar.x, bottom = sonar.y, top = sonar.y;
  const auto include = [&](double course) {
    left = std::min(left, sonar.x + reach * std::cos(course));
    right = std::max(right, sonar.x + reach * std::cos(course));
    bottom = std::min(bottom, sonar.y + reach * std::sin(course));
    top = std::max(top, sonar.y + reach * std::sin(course));
  };
  include(sonar.theta - view / 2.0);
  include(sonar.theta + view / 2.0);
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double course = quarter * kPi / 2.0;
    if (std::abs(wrapAngle(course - sonar.theta)) < view / 2.0) include(course);
  }
  const auto cell = [&](double metres, int count) {
    const double number = std::floor(metres / lattice.resolution());
    return static_cast<int>(std::clamp(number, -1.0, static_cast<double>(count)));
  };
  return {{std::max(cell(left, lattice.width()), 0), std::max(cell(bottom, lattice.height()), 0)},
          {std::min(cell(right, lattice.width()), lattice.width() - 1),
           std::min(cell(top, lattice.height()), lattice.height() - 1)}};
}

}  // namespace

double EvidenceGrid::deviation(double distance) const {
  const double of_cell = lattice_.resolution() / std::sqrt(12.0);
  return std::hypot(options_.evidence_sigma + kShareOfRange * distance, of_cell);
}

/// Into cone_: cells as far as three deviations behind an echo.
void EvidenceGrid::findCone(const Pose2& T_map_sonar, const Ping& ping) {
  cone_.clear();
  const Pose2 sonar = lattice_.toLattice(T_map_sonar);
  const double reach = ping.is_echo ? ping.range + kReach * deviation(ping.range) : ping.max_range;
  const Block block = blockAround(sonar, reach, ping.view, lattice_);
  for (int y = block.low.y; y <= block.high.y; ++y) {
    for (int x = block.low.x; x <= block.high.x; ++x) {
      const double dx = (x + 0.5) * lattice_.resolution() - sonar.x;
      const double dy = (y + 0.5) * lattice_.resolution() - sonar.y;
      const double distance = std::hypot(dx, dy);
      if (distance > reach) continue;
      const double course = std::atan2(dy, dx);
      const double bearing = wrapAngle(course - sonar.theta);
      if (std::abs(bearing) > ping.view / 2.0) continue;
      cone_.push_back({lattice_.index({x, y}), distance, bearing, wrapAngle(course + kPi)});
    }
  }
}

void EvidenceGrid::add(const Pose2& T_map_base, const SonarReading& reading) {
  const Pose2 T_map_sonar = T_map_base * reading.T_base_sonar;
  if (!isUsable(T_map_sonar, reading)) return;
  const Ping ping{std::min(reading.range, reading.max_range), reading.range < reading.max_range,
                  reading.max_range, reading.view};
  if (ping.is_echo && ping.range > options_.evidence_reach) return;
  findCone(T_map_sonar, ping);
  addCone(ping, cone_);
}

OccupancyGrid EvidenceGrid::toOccupancyGrid() const {
  std::vector<std::int8_t> cells(lattice_.size(), OccupancyGrid::kUnknown);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double probability = probabilityAt(i);
    if (probability > kOccupied) cells[i] = OccupancyGrid::kOccupied;
    if (probability < kFree) cells[i] = OccupancyGrid::kFree;
  }
  return OccupancyGrid(lattice_, std::move(cells));
}

}  // namespace adaptive_localization
