// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "map/evidence_grid.hpp"

namespace adaptive_localization {

/// A log likelihood ratio in each cell, of the readings if it is occupied to them if it is not. A
/// cell is detected with a probability a that falls with the distance, a reading is mirrored with a
/// probability q, and what else there may be echoes with a density u along the way:
///
///     a = k (1 - d / max_range) exp(-t^2 / (2 (w/4)^2))
///     L = log((1 - q) a N(D; d, s(d)) / u + 1 - (1 - q) a)     for d <= D + 3 s(d), else 0
///
/// without the first term if there was no echo, and not below 0 for d > D. It is negative before
/// the arc, positive on it and weaker farther away. Readings from about the same place err alike:
/// once a cell was seen from one of eight directions and two bands of distance, what is seen from
/// there again counts a tenth. The sum stays within 4 of zero, so that it can be overruled.
///
/// K. Konolige, "Improved occupancy grids for map building", Autonomous Robots 4(4), 1997, in this
/// consistent form. A thing alone in its cone would have u = 1 / max_range, but then each of the
/// cells of an arc is taken for what echoed, and arcs grow together. It takes more time and memory
/// than the others, and forgives readings that are too long.
class KonoligeGrid : public EvidenceGrid {
 public:
  KonoligeGrid(const Lattice& lattice, const EvidenceOptions& options);

 private:
  void addCone(const Ping& ping, const std::vector<ConeCell>& cells) override;
  double probabilityAt(std::size_t index) const override;
  double evidence(const Ping& ping, const ConeCell& cell) const;

  std::vector<double> evidence_;
  std::vector<std::uint16_t> views_;  // a bit for each direction and band
};

}  // namespace adaptive_localization
