// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/match/line_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

Eigen::Vector2d unit(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// The share of a scan's line that lies along the map's, which is longer by the slack at both ends.
double overlap(const Segment& mapped, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
               double slack) {
  const Eigen::Vector2d along = (mapped.b - mapped.a).normalized();
  const double from = along.dot(a - mapped.a);
  const double to = along.dot(b - mapped.a);
  const double low = std::max(std::min(from, to), -slack);
  const double high = std::min(std::max(from, to), (mapped.b - mapped.a).norm() + slack);
  const double length = std::abs(to - from);
  return length > 0.0 ? (high - low) / length : 0.0;
}

LineMatch compare(const Pose2& T_map_base, const ScanLine& line, const MapLine& landmark) {
  const Eigen::Vector2d normal = unit(landmark.alpha);
  LineMatch match;
  match.z = {line.rho, line.alpha};
  match.landmark = landmark;
  match.R = line.covariance;
  match.H << -normal.x(), -normal.y(), 0.0, 0.0, 0.0, -1.0;
  match.innovation = match.innovationAt(T_map_base);
  return match;
}

/// Squared Mahalanobis distance; infinite where it is none.
double distanceOf(const LineMatch& match, const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix2d S = match.H * covariance * match.H.transpose() + match.R;
  const double determinant = S.determinant();
  if (!(S(0, 0) > 0.0 && determinant > 0.0)) return std::numeric_limits<double>::infinity();
  return match.innovation.dot(S.inverse() * match.innovation);
}

}  // namespace

LineMap::LineMap(const std::vector<Segment>& surfaces) {
  for (const auto& segment : surfaces) {
    const Eigen::Vector2d along = segment.b - segment.a;
    if (!(along.norm() > 0.0)) continue;
    const double alpha = std::atan2(-along.x(), along.y());  // on the right of a -> b
    lines_.push_back({unit(alpha).dot(segment.a), alpha, segment});
  }
}

Eigen::Vector2d LineMatch::innovationAt(const Pose2& T_map_base) const {
  const double rho =
      landmark.rho - unit(landmark.alpha).dot(Eigen::Vector2d(T_map_base.x, T_map_base.y));
  return {z.x() - rho, wrapAngle(z.y() - (landmark.alpha - T_map_base.theta))};
}

std::vector<LineMatch> matchLines(const Pose2& T_map_base, const Eigen::Matrix3d& covariance,
                                  const std::vector<ScanLine>& lines, const LineMap& map,
                                  const LineOptions& options) {
  std::vector<LineMatch> matches;
  if (!isFinite(T_map_base) || !covariance.allFinite()) return matches;
  const double gate = options.line_gate + options.line_lead;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ScanLine& line = lines[i];
    const Eigen::Vector2d a = T_map_base * line.a;
    const Eigen::Vector2d b = T_map_base * line.b;
    LineMatch best;
    double least = std::numeric_limits<double>::infinity();
    double second = least;
    for (std::size_t j = 0; j < map.lines().size(); ++j) {
      const MapLine& landmark = map.lines()[j];
      LineMatch match = compare(T_map_base, line, landmark);
      const double apart = distanceOf(match, covariance);
      if (!(apart <= gate)) continue;
      const Eigen::Vector2d along = unit(landmark.alpha + kPi / 2.0);
      const double slack =
          2.0 * std::sqrt(std::max(0.0, along.dot(covariance.topLeftCorner<2, 2>() * along)));
      if (overlap(landmark.segment, a, b, slack) < options.line_overlap) continue;
      second = std::min(second, std::max(least, apart));
      if (apart < least) {
        least = apart;
        match.scan_line = static_cast<int>(i);
        match.map_line = static_cast<int>(j);
        best = match;
      }
    }
    if (least <= options.line_gate && second - least >= options.line_lead) matches.push_back(best);
  }
  return matches;
}

}  // namespace adaptive_localization
