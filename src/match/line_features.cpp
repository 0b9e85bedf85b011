// SPDX-License-Identifier: BSD-3-Clause
#include "match/line_features.hpp"

#include <algorithm>
#include <cmath>

#include "adaptive_localization/core/pose2.hpp"
#include "line_parts.hpp"

namespace adaptive_localization {
namespace {

using Point = Eigen::Vector2d;

constexpr double kGrazing = 10.0 * kPi / 180.0;  // walls seen at less are not followed, rad

/// Whether neighbours can lie on one wall (after Borges and Aldon 2004).
bool areJoined(const LineHit& a, const LineHit& b, double range_std) {
  const double turn = std::abs(wrapAngle(a.bearing - b.bearing));
  const double reach = std::max(a.range, b.range) * turn / std::sin(kGrazing) + 3.0 * range_std;
  return turn < kGrazing && (a.point - b.point).norm() < reach;
}

LineHits finiteHits(const Scan& scan) {
  LineHits hits;
  hits.reserve(static_cast<std::size_t>(scan.hits()));
  for (Eigen::Index i = 0; i < scan.hits(); ++i) {
    const Point point(scan.x[i], scan.y[i]);
    const LineHit hit{point, (point - scan.position).normalized(), scan.range[i], scan.bearing[i],
                      static_cast<int>(i)};
    if (point.allFinite() && std::isfinite(hit.range) && std::isfinite(hit.bearing)) {
      hits.push_back(hit);
    }
  }
  return hits;
}

LineHits withoutStrays(const LineHits& hits, double range_std) {
  LineHits kept;
  kept.reserve(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const LineHit& before = hits[i == 0 ? hits.size() - 1 : i - 1];
    const LineHit& after = hits[i + 1 == hits.size() ? 0 : i + 1];
    if (areJoined(before, hits[i], range_std) || areJoined(hits[i], after, range_std)) {
      kept.push_back(hits[i]);
    }
  }
  return kept;
}

/// Starts a full circle where no wall is cut.
void startAtBreak(LineHits& hits, double range_std) {
  if (hits.empty() || !areJoined(hits.back(), hits.front(), range_std)) return;
  for (std::size_t i = 1; i < hits.size(); ++i) {
    if (areJoined(hits[i - 1], hits[i], range_std)) continue;
    std::rotate(hits.begin(), hits.begin() + static_cast<std::ptrdiff_t>(i), hits.end());
    return;
  }
}

ScanLine describe(const LineHits& hits, const LinePart& part, double range_std) {
  FittedLine line = fitLine(hits, part);
  if (line.normal.dot(hits[part.first].beam) < 0.0) line.normal = -line.normal;
  const Point along(-line.normal.y(), line.normal.x());
  const double middle = along.dot(line.centre);

  double spread = 0.0, first = 0.0, second = 0.0, variances = 0.0;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const double t = along.dot(hits[i].point - line.centre);
    const double variance = range_std * range_std * line.noise(hits[i]);
    spread += t * t;
    variances += variance;
    first += variance * t;
    second += variance * t * t;
  }
  const auto count = static_cast<double>(part.size());
  const double turn = second / (spread * spread);     // variance of alpha
  const double offset = variances / (count * count);  // of the mean deviation
  const double shared = -first / (count * spread);    // their covariance

  ScanLine result;
  result.rho = line.normal.dot(line.centre);
  result.alpha = std::atan2(line.normal.y(), line.normal.x());
  result.covariance << offset + 2.0 * middle * shared + middle * middle * turn,
      shared + middle * turn, shared + middle * turn, turn;
  const auto onto = [&](const LineHit& hit) {
    return Point(line.centre + along * along.dot(hit.point - line.centre));
  };
  result.a = onto(hits[part.first]);
  result.b = onto(hits[part.last - 1]);
  for (std::size_t i = part.first; i < part.last; ++i) result.hits.push_back(hits[i].index);
  return result;
}

}  // namespace

std::vector<ScanLine> linesOf(const Scan& scan, const LineOptions& options) {
  LineHits hits = withoutStrays(finiteHits(scan), options.line_range_std);
  startAtBreak(hits, options.line_range_std);
  const auto least = static_cast<std::size_t>(options.line_least_points);
  std::vector<ScanLine> lines;
  for (std::size_t first = 0, last = 0; first < hits.size(); first = last) {
    last = first + 1;
    while (last < hits.size() && areJoined(hits[last - 1], hits[last], options.line_range_std)) {
      ++last;
    }
    for (const LinePart& part : partLines(hits, {first, last}, options)) {
      if (part.size() < least || !isLine(hits, part, options)) continue;
      const ScanLine line = describe(hits, part, options.line_range_std);
      if (line.length() >= options.line_least_length && line.covariance.allFinite()) {
        lines.push_back(line);
      }
    }
  }
  return lines;
}

}  // namespace adaptive_localization
