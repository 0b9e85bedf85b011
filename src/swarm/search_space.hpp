// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace adaptive_localization {

/// Where a swarm searches: an interval in each dimension.
struct SearchSpace {
  Eigen::ArrayXd low, high;
  bool is_torus{false};     // both ends of an interval are the same place
  bool has_heading{false};  // the last dimension is an angle, rad

  Eigen::Index dimensions() const { return low.size(); }
  double width(Eigen::Index k) const { return high[k] - low[k]; }
  bool isHeading(Eigen::Index k) const { return has_heading && k == dimensions() - 1; }

  /// Whether dimension k is a circle: those of a torus, and a heading that may be any.
  bool wraps(Eigen::Index k) const;

  /// How long that circle is: a whole turn for a heading, else the interval.
  double period(Eigen::Index k) const;

  /// The way from one coordinate to another: the short one on a circle.
  double way(Eigen::Index k, double from, double to) const;

  /// The same place within the interval on a circle, else the nearest end.
  double inside(Eigen::Index k, double value) const;
};

}  // namespace adaptive_localization
