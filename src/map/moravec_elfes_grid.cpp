// SPDX-License-Identifier: BSD-3-Clause
#include "map/moravec_elfes_grid.hpp"

#include <algorithm>

namespace adaptive_localization {
namespace {

double square(double x) {
  return x * x;
}

/// Two certainties together.
void enhance(double& certainty, double by) {
  certainty += by - certainty * by;
}

}  // namespace

MoravecElfesGrid::MoravecElfesGrid(const Lattice& lattice, const EvidenceOptions& options)
    : EvidenceGrid(lattice, options), empty_(lattice.size(), 0.0), occupied_(lattice.size(), 0.0) {}

void MoravecElfesGrid::addCone(const Ping& ping, const std::vector<ConeCell>& cells) {
  const double error = 3.0 * deviation(ping.range);
  const double free_until = ping.is_echo ? ping.range - error : ping.max_range;
  const double weight = ping.is_echo ? 1.0 : options().evidence_no_echo;
  double sum = 0.0;
  shares_.assign(cells.size(), 0.0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const ConeCell& cell = cells[i];
    const double across = 1.0 - square(2.0 * cell.bearing / ping.view);
    if (cell.distance < free_until) {
      enhance(empty_[cell.index], weight * (1.0 - square(cell.distance / free_until)) * across);
    } else if (ping.is_echo) {
      const double along = std::max(0.0, 1.0 - square((cell.distance - ping.range) / error));
      shares_[i] = along * across * (1.0 - empty_[cell.index]);
      sum += shares_[i];
    }
  }
  if (sum <= 0.0) return;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    enhance(occupied_[cells[i].index], shares_[i] / sum);
  }
}

double MoravecElfesGrid::probabilityAt(std::size_t index) const {
  const double value = occupied_[index] >= empty_[index] ? occupied_[index] : -empty_[index];
  return 0.5 * (1.0 + value);
}

}  // namespace adaptive_localization
