// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/belief.hpp"
#include "match/line_map.hpp"
#include "sonar_lines.hpp"

namespace adaptive_localization {

/// Recognises the walls of a map that sonars hear on the way. Units m and rad, poses of base in
/// map. Never throws, and nothing that is not finite comes out, whatever goes in.
class SonarLineMatcher {
 public:
  /// Segments with free space on the left of a -> b, as surfacesOf() gives them.
  SonarLineMatcher(const LineOptions& options, const std::vector<Segment>& surfaces)
      : options_(options), lines_(options), map_(surfaces) {}

  /// Moves on by odometry, motion = T_previous_current with its noise in the previous pose's frame.
  void move(const Pose2& motion, const Eigen::Matrix3d& noise) { lines_.move(motion, noise); }

  /// The walls that readings complete, as a Gaussian belief recognises them.
  std::vector<LineMatch> listen(const std::vector<SonarReading>& readings,
                                const Gaussian2& belief) {
    lines_.hear(readings);
    return matchLines(belief.mean, belief.covariance, lines_.takeLines(), map_, options_);
  }

  void forget() { lines_.forget(); }

 private:
  LineOptions options_;
  SonarLines lines_;
  LineMap map_;
};

}  // namespace adaptive_localization
