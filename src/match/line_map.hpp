// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/map/lattice.hpp"
#include "map/polygon.hpp"
#include "match/line_features.hpp"

namespace adaptive_localization {

/// A wall's face, cos(alpha) x + sin(alpha) y = rho in map: alpha points into the wall, so rho may
/// be negative, and the two faces of a wall are half a turn apart.
struct MapLine {
  double rho{0.0};                   // m
  double alpha{0.0};                 // rad
  Eigen::Vector2d normal{1.0, 0.0};  // (cos(alpha), sin(alpha))
  Segment segment;                   // free space on the left of a -> b
};

/// The lines of a map: landmarks that a scan's lines are looked for among.
class LineMap {
 public:
  /// Segments with free space on the left of a -> b, as surfacesOf() gives them; those without
  /// length are left out.
  explicit LineMap(const std::vector<Segment>& surfaces);

  const std::vector<MapLine>& lines() const { return lines_; }

 private:
  std::vector<MapLine> lines_;
};

/// The surfaces of the floor plan that the option line_map names. Throws std::invalid_argument
/// naming option, file and what was expected, also where none of them is within the map's lattice:
/// the plan is in another frame, then, or of another building.
std::vector<Segment> loadLineMap(const std::string& yaml_file, const Lattice& lattice);

/// A line of the scan recognised as one of the map: a measurement z = (rho, alpha) in base of
///
///     h(x, y, theta) = (rho_m - x cos(alpha_m) - y sin(alpha_m), alpha_m - theta),
///
/// linear in the pose: H = [[-cos(alpha_m), -sin(alpha_m), 0], [0, 0, -1]], R the
/// covariance of z and of what all of the line's hits have in common.
struct LineMatch {
  Eigen::Vector2d innovation;  // z - h(pose that it was matched from), m and rad, wrapped
  Eigen::Matrix<double, 2, 3> H;
  Eigen::Matrix2d R;
  int scan_line{0}, map_line{0};  // indices

  /// z - h of another pose, for corrections made one by one.
  Eigen::Vector2d innovationAt(const Pose2& T_map_base) const;

  Eigen::Vector2d z;
  MapLine landmark;
};

/// Looks for each of a scan's lines among those of the map, from a Gaussian belief of the pose. A
/// line is matched with the one of least nu^T (H P H^T + R)^-1 nu, if that is within the gate, if
/// the line lies along the map's segment (but for twice the belief's deviation that way), and if no
/// other line of the map is nearly as near. As alpha points into the wall, a face is never matched
/// from behind. A belief that is not finite matches nothing.
std::vector<LineMatch> matchLines(const Pose2& T_map_base, const Eigen::Matrix3d& covariance,
                                  const std::vector<ScanLine>& lines, const LineMap& map,
                                  const LineOptions& options);

}  // namespace adaptive_localization
