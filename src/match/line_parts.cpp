// SPDX-License-Identifier: BSD-3-Clause
#include "line_parts.hpp"

#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kMostNoise = 4.0;  // hits farther off, by their deviation, are of another line

using Point = Eigen::Vector2d;

std::size_t farthestFromChord(const LineHits& hits, const LinePart& part) {
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

void split(const LineHits& hits, LinePart part, const LineOptions& options,
           std::vector<LinePart>& parts) {
  const auto least = static_cast<std::size_t>(options.line_least_points);
  while (part.size() >= least && !isLine(hits, part, options)) {
    const std::size_t middle = farthestFromChord(hits, part);
    split(hits, {part.first, middle}, options, parts);
    part.first = middle;
  }
  parts.push_back(part);
}

void merge(const LineHits& hits, const LineOptions& options, std::vector<LinePart>& parts) {
  std::vector<LinePart> merged;
  for (const LinePart& part : parts) {
    const LinePart both{merged.empty() ? 0 : merged.back().first, part.last};
    if (!merged.empty() && isLine(hits, both, options)) {
      merged.back() = both;
    } else {
      merged.push_back(part);
    }
  }
  parts = std::move(merged);
}

/// Moves the border between two lines to where their hits deviate least.
void moveBorder(const LineHits& hits, LinePart& left, LinePart& right) {
  const FittedLine a = fitLine(hits, left), b = fitLine(hits, right);
  double sum = 0.0, least = 0.0;  // with the border at left.first, but for a constant
  std::size_t border = left.first;
  for (std::size_t i = left.first; i < right.last; ++i) {
    sum += a.square(hits[i]) / a.noise(hits[i]) - b.square(hits[i]) / b.noise(hits[i]);
    if (sum < least) {
      least = sum;
      border = i + 1;
    }
  }
  left.last = right.first = border;
}

void moveBorders(const LineHits& hits, const LineOptions& options, std::vector<LinePart>& parts) {
  const auto least = static_cast<std::size_t>(options.line_least_points);
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (parts[i - 1].size() >= least && parts[i].size() >= least) {
        moveBorder(hits, parts[i - 1], parts[i]);
      }
    }
  }
}

}  // namespace

FittedLine fitLine(const LineHits& hits, const LinePart& part) {
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

bool isLine(const LineHits& hits, const LinePart& part, const LineOptions& options) {
  const FittedLine line = fitLine(hits, part);
  const double variance = options.line_range_std * options.line_range_std;
  double sum = 0.0;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const double share = line.square(hits[i]) / (variance * line.noise(hits[i]));
    if (!(share <= kMostNoise * kMostNoise)) return false;
    sum += share;
  }
  const auto count = static_cast<double>(part.size());
  return sum <= count + kMostNoise * std::sqrt(2.0 * count);  // chi-square
}

std::vector<LinePart> partLines(const LineHits& hits, const LinePart& run,
                                const LineOptions& options) {
  std::vector<LinePart> parts;
  split(hits, run, options, parts);
  merge(hits, options, parts);
  moveBorders(hits, options, parts);
  return parts;
}

}  // namespace adaptive_localization
