// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/match/line_features.hpp"

#include <algorithm>
#include <cmath>

#include "adaptive_localization/pose2.hpp"

namespace adaptive_localization {
namespace {

using Point = Eigen::Vector2d;

constexpr double kGrazing = 10.0 * kPi / 180.0;  // walls seen at less are not followed, rad
constexpr double kLeftNoise = 0.1;               // of the range noise, across a grazed wall

struct Hit {
  Point point;
  double range;
  double bearing;
};
using Hits = std::vector<Hit>;

/// Hits from first to before last.
struct Part {
  std::size_t first, last;
  std::size_t size() const { return last - first; }
};

/// cos(alpha) x + sin(alpha) y = rho, of either sign.
struct Line {
  Point normal, centre;

  double deviation(const Point& point) const { return std::abs(normal.dot(point - centre)); }
};

/// Whether neighbours can lie on one wall (after Borges and Aldon 2004).
bool areJoined(const Hit& a, const Hit& b, double range_std) {
  const double turn = std::abs(wrapAngle(a.bearing - b.bearing));
  const double reach = std::max(a.range, b.range) * turn / std::sin(kGrazing) + 3.0 * range_std;
  return turn < kGrazing && (a.point - b.point).norm() < reach;
}

Hits finiteHits(const Scan& scan) {
  Hits hits;
  hits.reserve(static_cast<std::size_t>(scan.hits()));
  for (Eigen::Index i = 0; i < scan.hits(); ++i) {
    const Hit hit{{scan.x[i], scan.y[i]}, scan.range[i], scan.bearing[i]};
    if (hit.point.allFinite() && std::isfinite(hit.range) && std::isfinite(hit.bearing)) {
      hits.push_back(hit);
    }
  }
  return hits;
}

Hits withoutStrays(const Hits& hits, double range_std) {
  Hits kept;
  kept.reserve(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Hit& before = hits[i == 0 ? hits.size() - 1 : i - 1];
    const Hit& after = hits[i + 1 == hits.size() ? 0 : i + 1];
    if (areJoined(before, hits[i], range_std) || areJoined(hits[i], after, range_std)) {
      kept.push_back(hits[i]);
    }
  }
  return kept;
}

/// Starts a full circle where no wall is cut.
void startAtBreak(Hits& hits, double range_std) {
  if (hits.empty() || !areJoined(hits.back(), hits.front(), range_std)) return;
  for (std::size_t i = 1; i < hits.size(); ++i) {
    if (areJoined(hits[i - 1], hits[i], range_std)) continue;
    std::rotate(hits.begin(), hits.begin() + static_cast<std::ptrdiff_t>(i), hits.end());
    return;
  }
}

/// Total least squares.
Line fit(const Hits& hits, const Part& part) {
  Point centre = Point::Zero();
  for (std::size_t i = part.first; i < part.last; ++i) centre += hits[i].point;
  centre /= static_cast<double>(part.size());
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const Point p = hits[i].point - centre;
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    yy += p.y() * p.y();
  }
  const double alpha = 0.5 * std::atan2(-2.0 * xy, yy - xx);
  return {{std::cos(alpha), std::sin(alpha)}, centre};
}

bool isLine(const Hits& hits, const Part& part, double tolerance) {
  const Line line = fit(hits, part);
  return std::all_of(hits.begin() + static_cast<std::ptrdiff_t>(part.first),
                     hits.begin() + static_cast<std::ptrdiff_t>(part.last),
                     [&](const Hit& hit) { return line.deviation(hit.point) <= tolerance; });
}

std::size_t farthestFromChord(const Hits& hits, const Part& part) {
  const Point start = hits[part.first].point;
  const Point along = hits[part.last - 1].point - start;
  const Point normal(-along.y(), along.x());
  const bool is_closed = along.squaredNorm() == 0.0;  // ends where it began
  std::size_t farthest = part.first + 1;
  double most = -1.0;
  for (std::size_t i = part.first + 1; i + 1 < part.last; ++i) {
    const Point away = hits[i].point - start;
    const double deviation = is_closed ? away.norm() : std::abs(normal.dot(away));
    if (deviation > most) {
      most = deviation;
      farthest = i;
    }
  }
  return farthest;
}

void split(const Hits& hits, Part part, const LineOptions& options, std::vector<Part>& parts) {
  const auto least = static_cast<std::size_t>(options.line_least_points);
  while (part.size() >= least && !isLine(hits, part, options.line_split)) {
    const std::size_t middle = farthestFromChord(hits, part);
    split(hits, {part.first, middle}, options, parts);
    part.first = middle;
  }
  parts.push_back(part);
}

void merge(const Hits& hits, double tolerance, std::vector<Part>& parts) {
  std::vector<Part> merged;
  for (const Part& part : parts) {
    const Part both{merged.empty() ? 0 : merged.back().first, part.last};
    if (!merged.empty() && isLine(hits, both, tolerance)) {
      merged.back() = both;
    } else {
      merged.push_back(part);
    }
  }
  parts = std::move(merged);
}

ScanLine describe(const Hits& hits, const Part& part, const Point& sensor, double range_std) {
  Line line = fit(hits, part);
  if (line.normal.dot(line.centre - sensor) < 0.0) line.normal = -line.normal;
  const Point along(-line.normal.y(), line.normal.x());
  const double middle = along.dot(line.centre);

  double spread = 0.0, first = 0.0, second = 0.0, variances = 0.0;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const double t = along.dot(hits[i].point - line.centre);
    const Point beam = (hits[i].point - sensor).normalized();
    const double incidence = beam.dot(line.normal);
    const double variance =
        range_std * range_std * (incidence * incidence + kLeftNoise * kLeftNoise);
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
  const auto onto = [&](const Hit& hit) {
    return Point(line.centre + along * along.dot(hit.point - line.centre));
  };
  result.a = onto(hits[part.first]);
  result.b = onto(hits[part.last - 1]);
  result.points = static_cast<int>(part.size());
  return result;
}

}  // namespace

std::vector<ScanLine> linesOf(const Scan& scan, const LineOptions& options) {
  Hits hits = withoutStrays(finiteHits(scan), options.line_range_std);
  startAtBreak(hits, options.line_range_std);
  std::vector<ScanLine> lines;
  for (std::size_t first = 0, last = 0; first < hits.size(); first = last) {
    last = first + 1;
    while (last < hits.size() && areJoined(hits[last - 1], hits[last], options.line_range_std)) {
      ++last;
    }
    std::vector<Part> parts;
    split(hits, {first, last}, options, parts);
    merge(hits, options.line_split, parts);
    for (const Part& part : parts) {
      if (part.size() < static_cast<std::size_t>(options.line_least_points)) continue;
      const ScanLine line = describe(hits, part, scan.position, options.line_range_std);
      if (line.length() >= options.line_least_length && line.covariance.allFinite()) {
        lines.push_back(line);
      }
    }
  }
  return lines;
}

}  // namespace adaptive_localization
