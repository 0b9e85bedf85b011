// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/filters/filter.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "match/scan_matcher.hpp"
#include "particle/pose_sampler.hpp"
#include "ser/places.hpp"
#include "sim/free_space.hpp"
#include "swarm/range_objective.hpp"
#include "swarm/search_space.hpp"

namespace adaptive_localization {

/// A world with a laser in it that somebody has to find in a map of that world.
class SwarmFixScene {
 public:
  /// From a floor plan's YAML file; cells of the map and standard deviation of a range in m.
  SwarmFixScene(const std::string& world_file, double resolution, double noise);

  /// Anywhere on free ground.
  Pose2 place(Rng& rng) const;

  /// What the laser sees there: 181 beams over 180 degrees.
  Observations observe(const Pose2& T_map_base, Rng& rng) const;

  /// So many poses all over free space ("free"), the SER ("ser") or the found places ("places").
  Eigen::ArrayXXd spread(const std::string& where, int count, const Observations& observations,
                         Rng& rng) const;

  /// How badly poses fit 11 beams: the mean relative deviation, by the range table.
  TableObjective objective(const Scan& scan) const;

  /// The scan matched with the plan's walls, from a pose on; that pose where it cannot be.
  Pose2 matched(const Pose2& guess, const Scan& scan) const;

  /// The map's ends, and all headings.
  SearchSpace space(bool is_torus) const;

  /// For the filter of this name with so many particles or searchers, and these options;
  /// "lbba/seed": its preset.
  FilterContext contextFor(const std::string& filter, int particles, std::uint64_t seed,
                           const Parameters& options) const;

 private:
  std::string world_file_;
  double noise_;
  std::shared_ptr<const World> world_;
  FreeSpace free_space_;
  std::shared_ptr<const OccupancyGrid> map_;
  std::shared_ptr<const DistanceField> distance_field_;
  std::shared_ptr<Places> places_;
  std::shared_ptr<const RangeRows> rows_;
  std::unique_ptr<const ScanMatcher> matcher_;
};

}  // namespace adaptive_localization
