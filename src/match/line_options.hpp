// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

struct LineOptions {
  int line_least_points{8};
  double line_least_length{0.4};
  double line_range_std{0.03};
  double line_sonar_std{0.02};
  double line_map_std{0.01};
  double line_map_turn_std{0.002};
  double line_overlap{0.7};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("line_least_points", line_least_points, Range{3, 100000}, "",
           "Hits that make a line, at the least.");
    option("line_least_length", line_least_length, kPositive, "m",
           "Length of a line at the least.");
    option("line_range_std", line_range_std, kPositiveDeviation, "m",
           "Standard deviation of the laser's ranges, as lines take it.");
    option("line_sonar_std", line_sonar_std, kPositiveDeviation, "m",
           "The same of sonars; 1 % of the range comes on top.");
    option("line_map_std", line_map_std, kDeviation, "m",
           "Standard deviation of what all of a line's hits have in common: errors of the map's "
           "wall and of the laser's ranges.");
    option("line_map_turn_std", line_map_turn_std, kDeviation, "rad",
           "The same of a line's direction.");
    option("line_overlap", line_overlap, kProbability, "",
           "Share of a line's length that must lie along the map's line.");
  }
};

}  // namespace adaptive_localization
