// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "match/scan_matcher.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {

/// A room of 6 m by 4 m with a pillar of 1 m by 0.5 m, as lines, free space on the left.
inline std::vector<Segment> roomLines() {
  const std::vector<Eigen::Vector2d> room{{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  const std::vector<Eigen::Vector2d> pillar{{4, 1}, {4, 1.5}, {5, 1.5}, {5, 1}};
  std::vector<Segment> lines;
  forEachSide(room, [&](const Segment& side) { lines.push_back(side); });
  forEachSide(pillar, [&](const Segment& side) { lines.push_back(side); });
  return lines;
}

inline std::vector<Segment> corridorLines() {
  return {{{-50, 0}, {50, 0}}, {{50, 2}, {-50, 2}}};
}

inline std::shared_ptr<const SurfaceMap> surfacesOf(const std::vector<Segment>& lines) {
  return std::make_shared<const SurfaceMap>(Lattice(140, 100, 0.05, {-0.5, -0.5, 0.0}), lines);
}

/// What a laser at base sees of lines, 181 beams in front of it.
inline Scan scanAt(const Pose2& T_map_base, const std::vector<Segment>& lines, double noise = 0.0,
                   std::uint64_t seed = 1, double max_range = 8.0) {
  Rng rng(seed);
  std::vector<Eigen::Vector2d> hits;
  for (int i = 0; i <= 180; ++i) {
    const double bearing = (i - 90) * kPi / 180.0;
    const Eigen::Vector2d direction(std::cos(T_map_base.theta + bearing),
                                    std::sin(T_map_base.theta + bearing));
    double range = std::numeric_limits<double>::infinity();
    for (const Segment& line : lines) {
      range = std::min(range, hit(line, {T_map_base.x, T_map_base.y}, direction));
    }
    if (!(range < max_range)) continue;
    range += noise * rng.normal();
    hits.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  return hitsAt(hits, max_range).scan;
}

inline MatchOptions with(const std::string& metric, const std::string& outliers = "kernel") {
  MatchOptions options;
  options.match_metric = metric;
  options.match_outliers = outliers;
  options.match_max_iterations = metric == "point" ? 60 : 15;
  options.match_information = 1.0;
  options.match_map_std = options.match_map_turn_std = 0.0;  // the lines are exact
  return options;
}

inline const Pose2 kTruth{2.0, 2.3, 0.4};

}  // namespace adaptive_localization
