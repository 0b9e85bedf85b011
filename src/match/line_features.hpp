// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adaptive_localization/core/scan.hpp"
#include "match/line_options.hpp"

namespace adaptive_localization {

/// A straight line of hits, cos(alpha) x + sin(alpha) y = rho in base: alpha points from the sensor
/// to the line. rho is negative if the line runs between the sensor and the base's origin, so that
/// nothing jumps when the origin crosses it.
struct ScanLine {
  double rho{0.0};                                      // m
  double alpha{0.0};                                    // rad
  Eigen::Matrix2d covariance{Eigen::Matrix2d::Zero()};  // over (rho, alpha)
  Eigen::Vector2d a{0.0, 0.0}, b{0.0, 0.0};             // ends in base, m, as the beams pass them
  std::vector<int> hits;  // of the scan, in their order; none of sonars

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
