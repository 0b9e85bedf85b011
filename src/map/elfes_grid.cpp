// SPDX-License-Identifier: BSD-3-Clause
#include "map/elfes_grid.hpp"

#include <cmath>

namespace adaptive_localization {
namespace {

/// A normal density, relative to its height.
double bell(double deviations) {
  return std::exp(-0.5 * deviations * deviations);
}

}  // namespace

ElfesGrid::ElfesGrid(const Lattice& lattice, const EvidenceOptions& options)
    : EvidenceGrid(lattice, options), log_odds_(lattice.size(), 0.0) {}

void ElfesGrid::addCone(const Ping& ping, const std::vector<ConeCell>& cells) {
  const double s = deviation(ping.range);
  const double nearest = deviation(0.0);
  const double trust = options().evidence_trust * (ping.is_echo ? 1.0 : options().evidence_no_echo);
  for (const ConeCell& cell : cells) {
    const double across = bell(cell.bearing / (ping.view / 4.0));
    const double along = ping.is_echo ? bell((cell.distance - ping.range) / s) : 0.0;
    double told = nearest / s * along;
    if (cell.distance < ping.range) told -= nearest / deviation(cell.distance) * (1.0 - along);
    const double difference = trust * across * told;  // 2 p - 1
    log_odds_[cell.index] += std::log((1.0 + difference) / (1.0 - difference));
  }
}

double ElfesGrid::probabilityAt(std::size_t index) const {
  return 1.0 / (1.0 + std::exp(-log_odds_[index]));
}

}  // namespace adaptive_localization
