// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// What the inverse models of a sonar go by.
struct EvidenceOptions {
  double evidence_reach{2.0};
  double evidence_sigma{0.02};
  double evidence_trust{0.6};
  double evidence_no_echo{0.02};
  double evidence_mirrored{0.1};
  double evidence_others{1.5};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("evidence_reach", evidence_reach, Range{0.1, 100}, "m",
           "Longer readings are left out: most of them were mirrored.");
    option("evidence_sigma", evidence_sigma, Range{0.001, 1}, "m",
           "Standard deviation of a sonar's range; 1 % of the range comes on top.");
    option("evidence_trust", evidence_trust, Range{0.01, 0.99}, "",
           "What one reading tells at the most, of a near cell on the axis (not moravec-elfes).");
    option("evidence_no_echo", evidence_no_echo, kProbability, "",
           "What a ping without an echo counts for: most of them were mirrored away.");
    option("evidence_mirrored", evidence_mirrored, Range{0, 0.99}, "",
           "Probability that a reading was mirrored and is too long (konolige).");
    option("evidence_others", evidence_others, Range{0.01, 100}, "1/m",
           "Density of what else may echo, along a cone (konolige).");
  }
};

/// A grid in which readings of sonars, whose poses are known, add up to a map. The models differ in
/// what a reading says of the cells in its cone and in how that is combined; one that heard nothing
/// says that the cone is free, and says it weakly. Distances d are from the sonar, bearings t from
/// its axis, D is the reading and w the angle of the cone.
class EvidenceGrid {
 public:
  EvidenceGrid(const Lattice& lattice, const EvidenceOptions& options)
      : lattice_(lattice), options_(options) {}
  virtual ~EvidenceGrid() = default;

  const Lattice& lattice() const { return lattice_; }

  /// Takes in what a sonar of a robot heard. An echo from beyond evidence_reach is left out, and so
  /// is what makes no sense: a negative range, no finite max_range, a cone that is not in (0, pi].
  void add(const Pose2& T_map_base, const SonarReading& reading);

  /// That a cell is occupied; 1/2 where nothing is known, and outside.
  double probability(const Cell& cell) const {
    return lattice_.contains(cell) ? probabilityAt(lattice_.index(cell)) : 0.5;
  }

  /// Occupied cells (probability above 0.65), free ones (below 0.35) and unknown ones.
  OccupancyGrid toOccupancyGrid() const;

 protected:
  /// A reading as the models see it.
  struct Ping {
    double range;  // m; max_range if there was no echo
    bool is_echo;
    double max_range;  // m
    double view;       // w, rad
  };

  /// A cell with its centre in a cone, as far as the reading may tell of it.
  struct ConeCell {
    std::size_t index;
    double distance;   // d, m
    double bearing;    // t, rad
    double direction;  // from the cell to the sonar, rad in lattice coordinates
  };

  const EvidenceOptions& options() const { return options_; }

  /// Standard deviation s of a range d, m; that the echo came from anywhere in a cell is in it.
  double deviation(double distance) const;

  virtual void addCone(const Ping& ping, const std::vector<ConeCell>& cells) = 0;
  virtual double probabilityAt(std::size_t index) const = 0;

 private:
  void findCone(const Pose2& T_map_sonar, const Ping& ping);

  Lattice lattice_;
  EvidenceOptions options_;
  std::vector<ConeCell> cone_;  // of the last reading; its memory is used again
};

}  // namespace adaptive_localization
