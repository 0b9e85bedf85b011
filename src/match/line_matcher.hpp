// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "match/line_map.hpp"
#include "match/scan_matcher.hpp"

namespace adaptive_localization {

/// Aligns scans with a map of straight walls through the lines in both, each a landmark
/// (rho, alpha): with nu, H and R of the lines matched,
///
///     information L = sum H^T R^-1 H,   pose = guess + L^-1 sum H^T R^-1 nu,
///
/// along the directions of which the lines tell something. Lines are looked for once more from
/// there. Where walls are straight and the map has them as lines this is quicker than matching hits
/// and as exact; where little of a scan is straight, hits tell more.
///
/// Units m and rad, poses of base in map. Never throws, and never returns what is not finite, for
/// whatever scan and guess.
class LineMatcher {
 public:
  /// Segments with free space on the left of a -> b, as surfacesOf() gives them.
  LineMatcher(const LineOptions& options, const std::vector<Segment>& surfaces);

  /// The prior is the information over (x, y, theta) that the guess has, in which lines are looked
  /// for; along directions of which it has none, they are within 0.3 m and 0.15 rad. The pose found
  /// is that of the lines alone.
  Match match(const Pose2& guess, const Scan& scan,
              const Eigen::Matrix3d& prior = Eigen::Matrix3d::Zero()) const;

 private:
  LineOptions options_;
  LineMap map_;
};

}  // namespace adaptive_localization
