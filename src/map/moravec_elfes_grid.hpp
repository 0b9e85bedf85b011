// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "map/evidence_grid.hpp"

namespace adaptive_localization {

/// Two certainties in each cell, of being empty and of being occupied. With e = 3 s(D),
///
///     E = (1 - (d / (D - e))^2) (1 - (2 t / w)^2)     for d < D - e
///     O = (1 - ((d - D) / e)^2) (1 - (2 t / w)^2)     for |d - D| < e
///
/// and zero elsewhere. First Emp := Emp + E - Emp E in all cells. Then O, cancelled where the cell
/// is known to be empty and shared out over the arc, since one echo comes of one thing:
/// O := O (1 - Emp), O := O / sum O, Occ := Occ + O - Occ O. The map's value is Occ where Occ >=
/// Emp and -Emp elsewhere, the probability (1 + value) / 2.
///
/// H. P. Moravec, A. Elfes, "High resolution maps from wide angle sonar", ICRA 1985. The least
/// range of a sonar, which is in their E, is zero here.
class MoravecElfesGrid : public EvidenceGrid {
 public:
  MoravecElfesGrid(const Lattice& lattice, const EvidenceOptions& options);

 private:
  void addCone(const Ping& ping, const std::vector<ConeCell>& cells) override;
  double probabilityAt(std::size_t index) const override;

  std::vector<double> empty_, occupied_;
  std::vector<double> shares_;  // O of the cone's cells
};

}  // namespace adaptive_localization
