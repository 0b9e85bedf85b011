// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "map/evidence_grid.hpp"

namespace adaptive_localization {

/// A probability in each cell, by Bayes' rule from 1/2. Normal densities are in place of the
/// parabolas of 1985; both are as high as their deviation is small. With g = exp(-(d - D)^2 / (2
/// s(D)^2)), G = exp(-t^2 / (2 (w/4)^2)) and the trust k,
///
///     p = 1/2 + k G/2 (s(0) / s(D)) g                        for d >= D, up to three deviations
///     p = 1/2 + k G/2 ((s(0) / s(D)) g - (s(0) / s(d)) (1 - g))     for d < D
///
/// Log odds log(p / (1 - p)) add up, in whichever order the readings come.
///
/// A. Elfes, "Using occupancy grids for mobile robot perception and navigation", Computer 22(6),
/// 1989. The heights are ours.
class ElfesGrid : public EvidenceGrid {
 public:
  ElfesGrid(const Lattice& lattice, const EvidenceOptions& options);

 private:
  void addCone(const Ping& ping, const std::vector<ConeCell>& cells) override;
  double probabilityAt(std::size_t index) const override;

  std::vector<double> log_odds_;
};

}  // namespace adaptive_localization
