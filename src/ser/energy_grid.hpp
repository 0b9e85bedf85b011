// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "ser/range_table.hpp"
#include "ser/scan_energy.hpp"

namespace adaptive_localization {

struct EnergyGridOptions {
  int energy_beams{30};
  int energy_orientations{18};
  double energy_max_range{10.0};
  double ser_delta{0.02};
  double energy_grid_pitch{0.0};
  double energy_grid_max_memory{200.0};
  std::string cache_dir;

  template <class Visitor>
  void visit(Visitor&& option) {
    option("energy_beams", energy_beams, Range{1, kDirections}, "",
           "Beams of a scan whose ranges make its energy, evenly spread.");
    option("energy_orientations", energy_orientations, Range{1, kDirections}, "",
           "Headings per cell of the energy grid; a laser with a view of 360 degrees needs one.");
    option("energy_max_range", energy_max_range, Range{0.1, 1000}, "m",
           "Ranges are truncated to this for energies and the global search.");
    option("ser_delta", ser_delta, Range{0, 1}, "",
           "Largest difference in energy of similar poses; widened by the share of invalid beams.");
    option("energy_grid_pitch", energy_grid_pitch, Range{0, 10}, "m",
           "Distance between neighbouring positions of the energy grid and of the global search, "
           "rounded down to whole cells of the map; 0: every cell. 0.1 m on a map with cells of "
           "0.05 m takes a quarter of the memory and of the time to build it.");
    option("energy_grid_max_memory", energy_grid_max_memory, Range{1, 1e6}, "MB",
           "Memory limit of the energy grid: where it would take more, its positions lie further "
           "apart than energy_grid_pitch.");
    option("cache_dir", cache_dir, Choices{},
           "Folder in which energy grids are kept for the next start; empty: none.");
  }
};

/// The energy of a scan and how far it can be trusted.
struct ScanEnergy {
  double value{0.0};  // in [0, 1]
  double delta{0.0};  // half the width of its region
};

/// The energy grid of SAMCL and SA-KLD (Zhang, Zapata, Lepinay, IROS 2009; G_4D of the latter): the
/// energy that a scan taken in each free cell, or in every so many-th, with each of some headings
/// would have. It is sorted once it is first asked for energies, regions or poses: whoever only
/// searches the ranges does not pay for that.
///
///     E = (1 / I) sum_i (1 - z_i / z_max),     z_i at most z_max, which a no-return counts as
///
/// over I beams. Grid and robot use the same beams, cut-off and rule for no-returns, whatever
/// laser_max_beams says; invalid beams are left out of the robot's mean. Poses of similar energy
/// are two look-ups away: the Similar Energy Region (SER) is a run of the sorted list.
class EnergyGrid {
 public:
  /// Throws std::invalid_argument if the map has no free cell.
  EnergyGrid(const OccupancyGrid& map, const ScanGeometry& geometry,
             const EnergyGridOptions& options, const SweepProgress& progress = {});

  /// With ranges of the geometry's max_range, which grids of other geometries may share.
  EnergyGrid(std::shared_ptr<const RangeTable> ranges, const ScanGeometry& geometry,
             const EnergyGridOptions& options);

  const ScanGeometry& geometry() const { return geometry_; }
  const RangeTable& ranges() const { return *ranges_; }
  std::shared_ptr<const RangeTable> sharedRanges() const { return ranges_; }
  int orientations() const { return orientations_; }
  double headingStep() const { return 2.0 * kPi / orientations_; }

  /// Number of poses.
  std::size_t size() const { return ranges_->size() * static_cast<std::size_t>(orientations_); }

  /// None if the scan has no valid beam among the energy's.
  std::optional<ScanEnergy> energyOf(const Scan& scan) const;

  /// A run of poses in the order of their energies.
  struct Region {
    std::size_t begin{0};
    std::size_t end{0};
    std::size_t size() const { return end - begin; }
    bool isEmpty() const { return begin == end; }
  };

  /// The poses with |E - energy.value| < energy.delta.
  Region similarTo(const ScanEnergy& energy) const;

  /// Pose number i in the order of energies: of base in map, at its cell's centre and its heading.
  Pose2 pose(std::size_t i) const;
  double energy(std::size_t i) const;

  /// Base in map for a sensor there with base's heading; jitter moves it within cell and heading
  /// step, each in [-1/2, 1/2].
  Pose2 pose(std::size_t i, const Eigen::Vector3d& jitter) const;

  /// Every how many-th cell of the map, in x and y, energy_grid_pitch asks for.
  static int spacingAskedFor(const OccupancyGrid& map, const EnergyGridOptions& options);

  /// The same, or more to keep within energy_grid_max_memory.
  static int spacingFor(const OccupancyGrid& map, const ScanGeometry& geometry,
                        const EnergyGridOptions& options);

  /// Memory, with what regions need once they are asked for.
  std::size_t bytes() const {
    return ranges_->bytes() + (size() + countSums() + 1) * sizeof(std::uint32_t);
  }

 private:
  struct Sorted {
    std::vector<std::uint32_t> poses;   // cell * orientations + orientation, by ascending range sum
    std::vector<std::uint32_t> starts;  // [range sum]: first of poses with at least that sum
  };
  const Sorted& sorted() const;
  Sorted sort() const;
  std::size_t countSums() const { return directions_.size() * kNoReturn + 1; }
  int firstDirection(int orientation) const;
  int beams() const { return static_cast<int>(directions_.size()); }

  std::shared_ptr<const RangeTable> ranges_;
  ScanGeometry geometry_;
  int orientations_;
  std::vector<int> directions_;  // of the energy's beams, from beam 0 on
  double ser_delta_;
  mutable std::once_flag is_sorted_;
  mutable Sorted sorted_;
};

}  // namespace adaptive_localization
