// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "map/floor_plan.hpp"
#include "map/landmark_map.hpp"

namespace adaptive_localization {

/// What is really there and does not move: the truth that a simulated robot drives in.
class World {
 public:
  virtual ~World() = default;

  /// Metres from a ray's start (map frame, theta its direction) to the first solid surface;
  /// max_range if there is none before.
  virtual double range(const Pose2& T_map_ray, double max_range) const = 0;

  /// Metres from a point to the nearest solid thing: 0 within one, `cap` if all are farther.
  virtual double clearance(const Eigen::Vector2d& point, double cap) const = 0;

  virtual Bounds bounds() const = 0;
};

/// The plan's surfaces, exactly, with its furniture if asked for.
std::shared_ptr<const World> makeWorld(const FloorPlan& plan, bool furniture);

/// A map taken for the truth: occupied and unknown cells are solid to the robot, occupied ones to
/// the laser.
std::shared_ptr<const World> makeWorld(std::shared_ptr<const OccupancyGrid> grid);

/// A world with what its file says about driving in it.
struct Site {
  std::shared_ptr<const World> world;
  std::vector<Eigen::Vector2d> route;  // may be empty
  std::optional<Pose2> start;
  std::vector<Landmark> landmarks{};
  Paint paint{};
};

/// Reads a floor plan (a YAML file with an outline) or a map (a YAML file that names an image).
/// Throws std::invalid_argument naming the file and what is wrong with it.
Site loadSite(const std::string& yaml_file, bool furniture);

}  // namespace adaptive_localization
