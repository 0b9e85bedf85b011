// SPDX-License-Identifier: BSD-3-Clause
#include "plain_energies.hpp"

#include <cmath>

namespace adaptive_localization {
namespace {

/// Range in cells, in steps of one.
int march(const OccupancyGrid& map, const Cell& from, double angle, int steps) {
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  double x = from.x + 0.5;
  double y = from.y + 0.5;
  for (int range = 0; range < steps; ++range) {
    if (map.isOccupied({static_cast<int>(x), static_cast<int>(y)})) return range;
    x += dx;
    y += dy;
  }
  return steps;
}

}  // namespace

std::vector<float> plainEnergies(const OccupancyGrid& map, int headings, int beams,
                                 double max_range) {
  constexpr double kBeamStep = kPi / 30.0;
  const int steps = static_cast<int>(max_range / map.lattice().resolution());
  std::vector<float> energies;
  for (std::size_t i = 0; i < map.lattice().size(); ++i) {
    const Cell cell = map.lattice().cell(i);
    if (!map.isFree(cell)) continue;
    for (int heading = 0; heading < headings; ++heading) {
      double energy = 0.0;
      for (int beam = 0; beam < beams; ++beam) {
        const double angle = 2.0 * kPi * heading / headings - kPi / 2 + beam * kBeamStep;
        energy += 1.0 - static_cast<double>(march(map, cell, angle, steps)) / steps;
      }
      energies.push_back(static_cast<float>(energy / beams));
    }
  }
  return energies;
}

}  // namespace adaptive_localization
