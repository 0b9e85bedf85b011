// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/map/distance_field.hpp"

namespace adaptive_localization {

/// The yardstick of the measurements: the arithmetic that amcl does for its likelihood field, in
/// the most direct form. Cells of 16 bytes, particles as structures, and for each particle and beam
/// a cosine, a sine, a look-up in double precision and an exponential:
///
///     weight *= 1 + sum_i p_i^3,  p_i = z_hit exp(-d_i^2 / (2 sigma^2)) + z_rand / max_range
class PlainField {
 public:
  struct Sample {
    double x, y, theta, weight;
  };

  explicit PlainField(const DistanceField& field);

  void score(const Scan& scan, std::vector<Sample>& samples) const;

  static std::vector<Sample> samplesOf(const Particles& particles);

 private:
  struct Cell {
    int state;
    double distance;  // m
  };

  Lattice lattice_;
  std::vector<Cell> cells_;
};

}  // namespace adaptive_localization
