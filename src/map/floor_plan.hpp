// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "map/landmark_map.hpp"
#include "map/polygon.hpp"

namespace adaptive_localization {

/// What is painted on the floor, for people to see. In the YAML file:
///
///     paint:
///       line_width: 0.05                           # m
///       lines: [[[0, 0], [9, 0], [9, 6]], ...]     # centre lines
///       circles: [[4.5, 3, 0.75], ...]             # x, y and radius of centre lines
///       carpet: [-0.7, -0.7, 9.7, 6.7]             # two opposite corners of what is green
struct Paint {
  std::vector<Segment> lines;  // those of circles too
  double line_width{0.05};     // m
  std::optional<Bounds> carpet;
};

/// A building drawn with lines, the truth of a simulated world. Read from a YAML file:
///
///     outline: [[0, 0], [7, 0], [7, 4], [0, 4]]   # the inside; everything beyond is solid
///     wall_thickness: 0.1                          # m
///     walls: [[[3, 0], [3, 2]], ...]               # centre lines of inner walls
///     solids: [[[5, 1], [6, 1], [6, 2]], ...]      # columns, cupboards
///     furniture: [...]                             # solids that the map does not show
///     route: [[1, 1], [6, 3]]                      # way-points of the scripted drive, a loop
///     start: [1, 1, 0]                             # x, y, yaw
///     paint: {lines: [[[0, 1], [7, 1]]]}           # on the floor, see below
///     landmarks: [{id: 0, at: [1, 2]}, ...]        # what can be recognized, see landmark_file.hpp
///
/// Metres and radians in the map frame. Only the outline is required; other keys than these are
/// refused.
struct FloorPlan {
  Polygon outline;
  std::vector<Segment> walls;
  double wall_thickness{0.1};
  std::vector<Polygon> solids;
  std::vector<Polygon> furniture;
  std::vector<Eigen::Vector2d> route;
  std::optional<Pose2> start;
  Paint paint;
  std::vector<Landmark> landmarks;
};

/// Throws std::invalid_argument naming file, key and what was expected.
FloorPlan loadFloorPlan(const std::string& yaml_file);

/// All that is solid within the outline and on the map: solids, and walls as thick as they are.
std::vector<Polygon> solidsOf(const FloorPlan& plan);

/// Whether a point is inside the outline and in none of the solids.
bool isFree(const Polygon& outline, const std::vector<Polygon>& solids,
            const Eigen::Vector2d& point);

/// The sides that a laser sees: those of the outline, the walls and the solids, but not what lies
/// within another of them. Free space is on the left of a -> b. Furniture is left out, as in a map.
std::vector<Segment> surfacesOf(const FloorPlan& plan);

}  // namespace adaptive_localization
