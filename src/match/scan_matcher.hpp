// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/match/match.hpp"
#include "map/wall_vote.hpp"
#include "match/surface_maps.hpp"

namespace adaptive_localization {

struct MatchPair;
using MatchPairs = std::vector<MatchPair>;

struct MatchOptions {
  std::string match_metric{"line"};
  std::string match_outliers{"kernel"};
  int match_max_iterations{15};
  double match_reach{0.5};
  double match_reach_end{0.15};
  double match_kernel{0.1};
  double match_range_std{0.01};
  double match_surface_std{0.03};
  double match_information{0.1};
  double match_map_std{0.01};
  double match_map_turn_std{0.002};
  double match_least_inliers{0.4};
  std::string line_map;

  template <class Visitor>
  void visit(Visitor&& option) {
    option("match_metric", match_metric, Choices{"line", "point"},
           "Distance that a scan match minimizes: line, of hits from lines along the walls "
           "(point-to-line); point, from the nearest points of the map (point-to-point).");
    option("match_outliers", match_outliers, Choices{"none", "kernel", "trim", "ransac"},
           "Outliers of a scan match: kernel, weights that fall with the distance (Geman-McClure); "
           "trim, the best share alone; ransac, random sampling and then weights; none, no hit is "
           "one.");
    option("match_max_iterations", match_max_iterations, Range{1, 1000}, "",
           "Largest number of iterations of a scan match.");
    option("match_reach", match_reach, kPositive, "m",
           "Largest distance of a matched hit from the map's walls in the first iteration.");
    option("match_reach_end", match_reach_end, kPositive, "m",
           "Largest distance of a matched hit in the last iterations; match_reach shrinks to it by "
           "three tenths per iteration.");
    option("match_kernel", match_kernel, kPositive, "m",
           "Distance at which a hit has a quarter of its weight in the last iterations (kernel, "
           "ransac).");
    option("match_range_std", match_range_std, kPositiveDeviation, "m",
           "Standard deviation of the laser's ranges in a match.");
    option("match_surface_std", match_surface_std, kPositiveDeviation, "m",
           "Standard deviation of a wall's error in the map, independent for each hit.");
    option("match_information", match_information, Range{1e-6, 1}, "",
           "Factor on the information of a hit; less than 1, as neighbouring hits share the map's "
           "errors.");
    option("match_map_std", match_map_std, kDeviation, "m",
           "Standard deviation of the map's error that all hits share.");
    option("match_map_turn_std", match_map_turn_std, kDeviation, "rad",
           "Standard deviation of the map's error in heading that all hits share.");
    option(
        "match_least_inliers", match_least_inliers, kProbability, "",
        "Least share of the hits that fit the map after a match; with fewer it corrects nothing.");
    option("line_map", line_map, Choices{},
           "Floor plan (YAML, in the map's frame) whose exact walls are matched instead of the "
           "map's cells; empty: none.");
  }
};

/// Aligns scans with the map, from a pose near the right one (Besl and McKay 1992). With R, t of
/// the pose, p_i a hit and (q_i, n_i) the surface nearest to it:
///
///     line     min sum_i w_i (n_i . (R p_i + t - q_i))^2 / v_i   Gauss-Newton (Censi 2008)
///     point    min sum_i w_i |R p_i + t - q_i|^2                 in closed form (Horn 1987)
///     v_i = (range_std cos i)^2 + surface_std^2                  i the beam's angle of incidence
///
/// Pairs are found anew in each iteration. A hit where no wall faces the sensor, beyond the
/// wall's ends or out of reach is paired with nothing. Information is J^T W J / sigma^2, J the rows
/// (n, n . dR p), sigma^2 the larger of that of a beam at right angles and what the hits show;
/// where the eigenvalues say that hardly a hit tells of a direction, the pose is left as it was
/// guessed along it, and the information is 0. The information is that of point-to-line for either
/// metric: that of point-to-point would ignore that pairs change (Bonnabel et al. 2016). What all
/// hits have in common, the map's own error with its covariance M, is added to the covariance C of
/// the rows, C + H M H^T; rows are then turned into its eigenvectors.
///
/// Units m and rad, poses of base in map. Matching never throws, and never returns what is not
/// finite, for whatever scan and guess.
class ScanMatcher {
 public:
  /// Throws std::invalid_argument if match_reach is less than match_reach_end.
  ScanMatcher(const MatchOptions& options, std::shared_ptr<const SurfaceMap> surfaces);

  /// The pose near a guess that fits the scan. With a prior, the information over (x, y, theta)
  /// that the guess has, which may be singular, lines make the sum above / sigma^2 and the guess's
  /// Mahalanobis distance small together: the step of an iterated Kalman filter (Bell and Cathey
  /// 1993). Points know no prior: their pose is that of the scan alone.
  Match match(const Pose2& guess, const Scan& scan,
              const Eigen::Matrix3d& prior = Eigen::Matrix3d::Zero()) const;

  /// Matches with these surfaces as well: those that scans fit better, on the way so far, count.
  void tryAlso(ScanMatcher other);

 private:
  Match matchAlone(const Pose2& guess, const Scan& scan, const Eigen::Matrix3d& prior) const;
  double badness(const Match& match) const;
  void align(const Scan& scan, const Eigen::Matrix3d& prior, Match& match) const;
  double hitVariance() const;
  double precisionOf(const Eigen::Vector2d& normal, const Eigen::Vector2d& ray) const;
  void pairAt(const Pose2& T_map_base, const Scan& scan, double reach, MatchPairs& pairs) const;
  void weigh(MatchPairs& pairs, int hits, double reach) const;
  void rate(const Scan& scan, Match& match) const;

  MatchOptions options_;
  std::shared_ptr<const SurfaceMap> surfaces_;
  std::shared_ptr<const ScanMatcher> other_;
  mutable WallVote vote_;
};

/// On the surfaces of a map, or of the floor plan that the options name. Where the map's walls are
/// thick, on their faces or their middles, whichever the scans fit: walls painted from a plan have
/// faces where a laser sees them, those made of scans laid over each other inexactly do not. Throws
/// std::invalid_argument naming the option and what is wrong with it.
ScanMatcher makeScanMatcher(const MatchOptions& options, SurfaceMaps& surfaces);

}  // namespace adaptive_localization
