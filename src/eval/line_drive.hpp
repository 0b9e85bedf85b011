// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/options.hpp"
#include "map/polygon.hpp"

namespace adaptive_localization {

/// A drive through a floor plan by a robot that knows its start, followed by Kalman filters.
struct LineDrivePlan {
  std::string world;      // YAML file of a floor plan
  double duration{60.0};  // s
  Parameters robot;       // of the simulated robot, SimulationOptions
  Parameters options;     // of ekf_icp, and how scans are read
};

/// What is true after a scan, and what is believed.
struct LineDriveStep {
  double stamp{0.0};   // s
  double driven{0.0};  // m
  Pose2 T_map_base;    // the truth
  Gaussian2 odometry;  // of a filter that observes nothing
  Gaussian2 lines;     // of one that is corrected by the lines in scans
};

/// A line of a scan, in map.
struct SeenLine {
  Segment segment;
  bool is_matched{false};  // with one of the map
};

struct LineDrive {
  std::vector<Segment> walls;  // of the floor plan
  std::vector<LineDriveStep> steps;
  std::vector<Eigen::Vector2d> hits;  // of the last scan, in map from where the filter believes
  std::vector<SeenLine> seen;         // the lines among them
  std::vector<Segment> matched;       // those of the map that they were matched with
};

/// Two filters `ekf_icp` go along, both from the true pose with 0.05 m and 0.02 rad: one with
/// `ekf_landmarks: lines`, and one that is given no scans. Throws std::invalid_argument naming the
/// file or option, the value and what was expected.
LineDrive driveByLines(const LineDrivePlan& plan);

/// The area in m^2 of the ellipse in which the robot is with 99 %: of positions p with
/// (p - mean)^T P^-1 (p - mean) <= -2 ln 0.01, P the covariance over (x, y).
double ellipseArea(const Gaussian2& belief);

/// The standard deviation in m of the position in the direction (map frame) of an angle in rad.
double deviationAlong(const Gaussian2& belief, double angle);

/// Errors, deviations across and along the robot's way and areas, at eleven moments.
std::string toTable(const LineDrive& drive);

/// Steps with poses and covariances (xx, xy, yy), walls, and what was seen last; metres, seconds,
/// radians, in map. scripts/draw draws it.
nlohmann::json toJson(const LineDrive& drive);

}  // namespace adaptive_localization
