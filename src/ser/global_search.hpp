// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "ser/energy_grid.hpp"
#include "ser/search_pose.hpp"

namespace adaptive_localization {

struct GlobalSearchOptions {
  double search_truncation{0.5};
  double search_margin{0.05};
  double search_max_error{0.3};
  int search_max_places{400};
  int search_max_visits{6000000};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("search_truncation", search_truncation, kPositive, "m",
           "Range errors are truncated to this in the global search.");
    option("search_margin", search_margin, kNotNegative, "m",
           "Candidates of the global search have a mean range error per beam within this of the "
           "best one's.");
    option("search_max_error", search_max_error, kPositive, "m",
           "Largest mean range error per beam of a candidate of the global search.");
    option("search_max_places", search_max_places, Range{1, 10000}, "",
           "Largest number of candidates of the global search.");
    option("search_max_visits", search_max_visits, kWhole, "",
           "Poses that one global search evaluates at the most, the most promising ones first; 0: "
           "as many as an exact answer needs.");
  }
};

class PlaceRefiner;
class PoseSearch;
struct PoseSearchLimits;

/// Where was this scan taken? Compares it with what would be seen from every free cell in every
/// direction, and leaves none out that could matter:
///
///     cost(pose) = sum_i min(|z_i* - z_i|, c)
///
/// The energies of single directions, as intervals over a block of neighbouring cells and headings,
/// bound the cost of all poses in the block from below (the triangle inequality that makes the SER
/// work, per direction). Blocks are opened in the order of their bounds, by and large, until no
/// bound is below the best cost plus the margin: the same answer as looking at every pose, for a
/// fraction of the work. Only where search_max_visits is reached, in a large building that looks
/// alike all over, may some of the poses within the margin be missing.
class GlobalSearch {
 public:
  GlobalSearch(std::shared_ptr<const EnergyGrid> grid, std::shared_ptr<const OccupancyGrid> map,
               std::shared_ptr<const DistanceField> field, const GlobalSearchOptions& options);

  /// All lattice poses within the margin of the best, none above search_max_error and 100 000 at
  /// the most, best first, ties by cell and direction.
  std::vector<SearchPose> findPoses(const DirectionalScan& scan) const;

  /// The same, to be done in parts.
  std::unique_ptr<PoseSearch> begin(const DirectionalScan& scan) const;

  /// Moves poses to where the scan, which must outlive it, fits best nearby.
  std::unique_ptr<const PlaceRefiner> refinerFor(const Scan& scan) const;

  const RangeTable& ranges() const { return grid_->ranges(); }
  const ScanGeometry& geometry() const { return grid_->geometry(); }
  const GlobalSearchOptions& options() const { return options_; }

  /// Poses whose cost was computed in the last findPoses(), as a share of all.
  double visitedShare() const { return visited_share_; }

 private:
  int truncation() const;                                      // steps
  int steps(double error, const DirectionalScan& scan) const;  // of a mean error per beam
  PoseSearchLimits limitsFor(const DirectionalScan& scan) const;

  std::shared_ptr<const EnergyGrid> grid_;
  std::shared_ptr<const OccupancyGrid> map_;
  std::shared_ptr<const DistanceField> field_;
  GlobalSearchOptions options_;
  mutable double visited_share_{0.0};
};

}  // namespace adaptive_localization
