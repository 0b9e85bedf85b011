// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adaptive_localization/options.hpp"
#include "adaptive_localization/scan.hpp"

namespace adaptive_localization {

struct LineOptions {
  int line_least_points{8};
  double line_least_length{0.4};
  double line_split{4.0};
  double line_range_std{0.03};
  double line_map_std{0.01};
  double line_map_turn_std{0.002};
  double line_gate{9.21};
  double line_lead{4.0};
  double line_overlap{0.7};
  double line_least_inliers{0.2};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("line_least_points", line_least_points, Range{3, 100000}, "",
           "Hits that make a line, at the least.");
    option("line_least_length", line_least_length, kPositive, "m",
           "Length of a line at the least.");
    option("line_split", line_split, kPositive, "",
           "Hits farther from a line than so many times their noise are not of it.");
    option("line_range_std", line_range_std, kPositiveDeviation, "m",
           "Standard deviation of the laser's ranges, as lines take it.");
    option("line_map_std", line_map_std, kDeviation, "m",
           "Standard deviation of what all of a line's hits have in common: errors of the map's "
           "wall and of the laser's ranges.");
    option("line_map_turn_std", line_map_turn_std, kDeviation, "rad",
           "The same of a line's direction.");
    option("line_gate", line_gate, kPositive, "",
           "Squared Mahalanobis distance up to which a line of the scan can be one of the map; "
           "9.21: 99 % of the right ones.");
    option("line_lead", line_lead, kNotNegative, "",
           "By how much the next best line of the map must be farther, in the same measure; with "
           "less the line is not used.");
    option("line_overlap", line_overlap, kProbability, "",
           "Share of a line's length that must lie along the map's line.");
    option("line_least_inliers", line_least_inliers, kProbability, "",
           "A scan of which a smaller share is on matched lines is not matched.");
  }
};

/// A straight line of hits, cos(alpha) x + sin(alpha) y = rho in base: alpha points from the sensor
/// to the line. rho is negative if the line runs between the sensor and the base's origin, so that
/// nothing jumps when the origin crosses it.
struct ScanLine {
  double rho{0.0};                                      // m
  double alpha{0.0};                                    // rad
  Eigen::Matrix2d covariance{Eigen::Matrix2d::Zero()};  // over (rho, alpha)
  Eigen::Vector2d a{0.0, 0.0}, b{0.0, 0.0};             // ends in base, m, as the beams pass them
  std::vector<int> hits;                                // of the scan, in their order

  double length() const { return (b - a).norm(); }
};

/// The straight lines in a scan, by split and merge (the best of six in Nguyen et al. 2007): the
/// hits in their order are parted where neighbours lie too far apart for any wall seen at 10
/// degrees or more, then at the one farthest from the chord until each part is a total least
/// squares line and noise; neighbouring parts that are one line are joined, and where two lines
/// meet, their border goes to where the hits fit best. Single hits away from both neighbours are
/// left out first.
///
/// The noise is that of the ranges: across the line, of a beam with cosine of incidence c,
///
///     var(e) = sigma^2 (c^2 + 0.1^2);
///
/// 0.1 stands for what is left of it along a grazed wall. With t the hits' places along the line
/// and T their mean, the line's errors, and from them its covariance, are
///
///     d alpha = -sum (t - T) e / sum (t - T)^2,   d rho = mean(e) + T d alpha.
///
/// Never throws, and nothing that is not finite comes out, for whatever scan.
std::vector<ScanLine> linesOf(const Scan& scan, const LineOptions& options);

}  // namespace adaptive_localization
