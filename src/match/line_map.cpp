// SPDX-License-Identifier: BSD-3-Clause
#include "match/line_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "cells_along.hpp"
#include "core/chi_square.hpp"
#include "map/floor_plan.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLead = 4.0;  // by which the next best line must be farther, in the gate's measure

/// Squared Mahalanobis distance within which 99 % of the right lines are, by rho and alpha.
double gate() {
  static const double most = chiSquare(2, 0.99);
  return most;
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

struct Candidate {
  LineMatch match;
  double apart;  // squared Mahalanobis distance
};

/// The map's lines within the gate and the lead, along which the scan's line lies.
class Search {
 public:
  Search(const Pose2& T_map_base, const Eigen::Matrix3d& covariance, const LineMap& map,
         const LineOptions& options)
      : T_map_base_(T_map_base), covariance_(covariance), map_(map), options_(options) {}

  std::vector<Candidate> candidates(const ScanLine& line) const {
    std::vector<Candidate> found;
    const Eigen::Vector2d a = T_map_base_ * line.a;
    const Eigen::Vector2d b = T_map_base_ * line.b;
    for (std::size_t i = 0; i < map_.lines().size(); ++i) {
      const MapLine& landmark = map_.lines()[i];
      LineMatch match = compare(line, landmark);
      const double apart = distanceOf(match);
      if (!(apart <= gate() + kLead)) continue;
      if (overlap(landmark.segment, a, b, slackAlong(landmark)) < options_.line_overlap) continue;
      match.map_line = static_cast<int>(i);
      found.push_back({match, apart});
    }
    return found;
  }

 private:
  LineMatch compare(const ScanLine& line, const MapLine& landmark) const {
    LineMatch match;
    match.z = {line.rho, line.alpha};
    match.landmark = landmark;
    match.R = line.covariance;
    match.R(0, 0) += options_.line_map_std * options_.line_map_std;
    match.R(1, 1) += options_.line_map_turn_std * options_.line_map_turn_std;
    match.H << -landmark.normal.x(), -landmark.normal.y(), 0.0, 0.0, 0.0, -1.0;
    match.innovation = match.innovationAt(T_map_base_);
    return match;
  }

  /// Infinite where it is none.
  double distanceOf(const LineMatch& match) const {
    const Eigen::Matrix2d S = match.H * covariance_ * match.H.transpose() + match.R;
    const double determinant = S.determinant();
    if (!(S(0, 0) > 0.0 && determinant > 0.0)) return std::numeric_limits<double>::infinity();
    return match.innovation.dot(S.inverse() * match.innovation);
  }

  double slackAlong(const MapLine& landmark) const {
    const Eigen::Vector2d along(-landmark.normal.y(), landmark.normal.x());
    const double variance = along.dot(covariance_.topLeftCorner<2, 2>() * along);
    return 2.0 * std::sqrt(std::max(0.0, variance));
  }

  const Pose2& T_map_base_;
  const Eigen::Matrix3d& covariance_;
  const LineMap& map_;
  const LineOptions& options_;
};

bool isWithin(const Lattice& lattice, const Segment& segment) {
  bool is_within = false;
  forEachCellAlong(lattice, segment, [&](const Cell&) { is_within = true; });
  return is_within;
}

std::string toText(const Bounds& bounds) {
  std::ostringstream text;
  text << "x from " << bounds.low.x() << " to " << bounds.high.x() << ", y from " << bounds.low.y()
       << " to " << bounds.high.y() << " m";
  return text.str();
}

Bounds extentOf(const Lattice& lattice) {
  const Pose2& origin = lattice.origin();
  const double width = lattice.width() * lattice.resolution();
  const double height = lattice.height() * lattice.resolution();
  using Point = Eigen::Vector2d;
  return boundsOf(Polygon{origin * Point(0, 0), origin * Point(width, 0), origin * Point(0, height),
                          origin * Point(width, height)});
}

/// Two pieces of one straight wall say the same.
bool saySame(const LineMatch& a, const LineMatch& b) {
  constexpr double kSame = 1e-3;  // m and rad
  return (a.innovation - b.innovation).cwiseAbs().maxCoeff() < kSame;
}

}  // namespace

LineMap::LineMap(const std::vector<Segment>& surfaces) {
  for (const auto& segment : surfaces) {
    const Eigen::Vector2d along = segment.b - segment.a;
    if (!(along.norm() > 0.0)) continue;
    const Eigen::Vector2d normal = Eigen::Vector2d(along.y(), -along.x()).normalized();
    lines_.push_back({normal.dot(segment.a), std::atan2(normal.y(), normal.x()), normal, segment});
  }
}

std::vector<Segment> loadLineMap(const std::string& yaml_file, const Lattice& lattice) {
  FloorPlan plan;
  try {
    plan = loadFloorPlan(yaml_file);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("option 'line_map': " + std::string(error.what()));
  }
  std::vector<Segment> surfaces = surfacesOf(plan);
  const bool is_on_map = std::any_of(surfaces.begin(), surfaces.end(), [&](const Segment& surface) {
    return isWithin(lattice, surface);
  });
  if (is_on_map) return surfaces;
  throw std::invalid_argument("option 'line_map': floor plan '" + yaml_file +
                              "': none of its walls (" + toText(boundsOf(plan.outline)) +
                              ") is on the map, expected some within " + toText(extentOf(lattice)));
}

Eigen::Vector2d LineMatch::innovationAt(const Pose2& T_map_base) const {
  const double rho =
      landmark.rho - landmark.normal.dot(Eigen::Vector2d(T_map_base.x, T_map_base.y));
  return {z.x() - rho, wrapAngle(z.y() - (landmark.alpha - T_map_base.theta))};
}

std::vector<LineMatch> matchLines(const Pose2& T_map_base, const Eigen::Matrix3d& covariance,
                                  const std::vector<ScanLine>& lines, const LineMap& map,
                                  const LineOptions& options) {
  std::vector<LineMatch> matches;
  if (!isFinite(T_map_base) || !covariance.allFinite()) return matches;
  const Search search(T_map_base, covariance, map, options);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<Candidate> candidates = search.candidates(lines[i]);
    const auto best =
        std::min_element(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) { return a.apart < b.apart; });
    if (best == candidates.end() || best->apart > gate()) continue;
    const bool has_rival =
        std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
          return other.apart < best->apart + kLead && !saySame(other.match, best->match);
        });
    if (has_rival) continue;
    matches.push_back(best->match);
    matches.back().scan_line = static_cast<int>(i);
  }
  return matches;
}

}  // namespace adaptive_localization
