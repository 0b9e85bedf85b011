// SPDX-License-Identifier: BSD-3-Clause
#include "map/konolige_grid.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr int kDirections = 8;
constexpr double kRepeated = 0.1;      // weight of what was seen so before
constexpr double kMostEvidence = 4.0;  // of all readings together
constexpr double kReach = 3.0;         // deviations behind an arc

/// The bit of where a cell was seen from.
std::uint16_t viewBit(double direction, bool is_far) {
  const double turn = (direction + kPi) / (2.0 * kPi);
  const int sector = std::min(static_cast<int>(turn * kDirections), kDirections - 1);
  return static_cast<std::uint16_t>(1U << (sector + (is_far ? kDirections : 0)));
}

}  // namespace

KonoligeGrid::KonoligeGrid(const Lattice& lattice, const EvidenceOptions& options)
    : EvidenceGrid(lattice, options), evidence_(lattice.size(), 0.0), views_(lattice.size(), 0) {}

double KonoligeGrid::evidence(const Ping& ping, const ConeCell& cell) const {
  const double s = deviation(cell.distance);
  if (ping.is_echo && cell.distance > ping.range + kReach * s) return 0.0;
  const double off_axis = cell.bearing / (ping.view / 4.0);
  const double detected = options().evidence_trust *
                          std::max(0.0, 1.0 - cell.distance / ping.max_range) *
                          std::exp(-0.5 * off_axis * off_axis);
  const double a = (1.0 - options().evidence_mirrored) * detected;
  if (!ping.is_echo) return options().evidence_no_echo * std::log(1.0 - a);
  const double off = (ping.range - cell.distance) / s;
  const double density = std::exp(-0.5 * off * off) / (s * std::sqrt(2.0 * kPi));
  const double told = std::log(a * density / options().evidence_others + 1.0 - a);
  return cell.distance < ping.range ? told : std::max(0.0, told);
}

void KonoligeGrid::addCone(const Ping& ping, const std::vector<ConeCell>& cells) {
  for (const ConeCell& cell : cells) {
    const double told = evidence(ping, cell);
    if (told == 0.0) continue;
    const std::uint16_t bit = viewBit(cell.direction, cell.distance > ping.max_range / 2.0);
    std::uint16_t& views = views_[cell.index];
    const double weight = (views & bit) != 0 ? kRepeated : 1.0;
    views = static_cast<std::uint16_t>(views | bit);
    double& sum = evidence_[cell.index];
    sum = std::clamp(sum + weight * told, -kMostEvidence, kMostEvidence);
  }
}

double KonoligeGrid::probabilityAt(std::size_t index) const {
  return 1.0 / (1.0 + std::exp(-evidence_[index]));
}

}  // namespace adaptive_localization
