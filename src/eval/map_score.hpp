// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "map/evidence_grid.hpp"

namespace adaptive_localization {

/// How good a map is that was made, against the true one. What counts are the cells that the truth
/// knows, seen or not: the free ones and the surfaces.
struct MapScore {
  std::size_t cells{0};       // that count
  double entropy{0.0};        // -p log2 p - (1 - p) log2(1 - p), mean over the cells, bits
  double known_share{0.0};    // of the cells, said to be free or occupied
  double correct_share{0.0};  // of the cells, said to be what they are
  double precision{0.0};      // share of the occupied cells that are near a true one
  double recall{0.0};         // share of the true occupied cells that are near a made one
  double f_score{0.0};        // harmonic mean of precision and recall
};

/// A true map as a map of a lattice would be at best: cells in which there is a surface are
/// occupied, an occupied cell of the truth beside a free one; what is behind is unknown, since
/// nothing sees it.
OccupancyGrid surfacesOn(const Lattice& lattice, const OccupancyGrid& truth);

/// Cells are near if they are the same or neighbours, diagonal ones too. `surfaces` has the grid's
/// lattice; throws std::invalid_argument if not, or if it has no cell that counts.
MapScore scoreOf(const EvidenceGrid& made, const OccupancyGrid& surfaces);

}  // namespace adaptive_localization
