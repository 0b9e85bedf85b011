// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "match/line_options.hpp"

namespace adaptive_localization {

struct LineHit {
  Eigen::Vector2d point, beam;  // in base; the beam of length 1
  double range;
  double bearing;
  int index;  // in the scan
};
using LineHits = std::vector<LineHit>;

/// Hits from first to before last.
struct LinePart {
  std::size_t first, last;
  std::size_t size() const { return last - first; }
};

/// Through its centre, across its normal.
struct FittedLine {
  Eigen::Vector2d normal, centre;

  /// Squared deviation of a hit, and what range noise of variance 1 makes of it on average.
  double square(const LineHit& hit) const {
    const double deviation = normal.dot(hit.point - centre);
    return deviation * deviation;
  }
  double noise(const LineHit& hit) const {
    constexpr double kLeft = 0.1;  // of the range noise, along a grazed wall
    const double incidence = normal.dot(hit.beam);
    return incidence * incidence + kLeft * kLeft;
  }
};

/// Total least squares.
FittedLine fitLine(const LineHits& hits, const LinePart& part);

/// Whether the hits are a line and noise: none too far off, and not all of them rather far.
bool isLine(const LineHits& hits, const LinePart& part, const LineOptions& options);

/// Parts a run of neighbouring hits into lines, and rests that are none.
std::vector<LinePart> partLines(const LineHits& hits, const LinePart& run,
                                const LineOptions& options);

}  // namespace adaptive_localization
