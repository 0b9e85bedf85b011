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
    option("line_least_points", line_least_points, Range{3, 100000}, "", "Fewest hits of a line.");
    option("line_least_length", line_least_length, kPositive, "m", "Shortest line.");
    option("line_range_std", line_range_std, kPositiveDeviation, "m",
           "Standard deviation of the laser's ranges when lines are found.");
    option("line_sonar_std", line_sonar_std, kPositiveDeviation, "m",
           "Standard deviation of sonar ranges when lines are found; 1 % of the measured range is "
           "added to it.");
    option("line_map_std", line_map_std, kDeviation, "m",
           "Standard deviation of the error that all hits of a line share: of the map's wall and "
           "the laser's offset.");
    option("line_map_turn_std", line_map_turn_std, kDeviation, "rad",
           "Standard deviation of the error in direction that all hits of a line share.");
    option("line_overlap", line_overlap, kProbability, "",
           "Least share of a line's length that lies along the line of the map.");
  }
};

}  // namespace adaptive_localization
