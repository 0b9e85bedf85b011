// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "sim/simulation.hpp"

namespace adaptive_localization {

/// The worlds that come with the package.
inline const std::array<std::string, 4> kWorlds{"maze", "expansion", "symmetric", "corridor"};

inline std::string worldFile(const std::string& name) {
  return SOURCE_DIR "/maps/" + name + "/world.yaml";
}
inline std::string mapFile(const std::string& name) {
  return SOURCE_DIR "/maps/" + name + "/map.yaml";
}

/// A hall of 10 x 6 m with a column of 1 x 1 m, and a box that no map shows.
inline FloorPlan hall() {
  FloorPlan plan;
  plan.outline = {{0, 0}, {10, 0}, {10, 6}, {0, 6}};
  plan.solids = {{{4, 2}, {5, 2}, {5, 3}, {4, 3}}};
  plan.furniture = {{{8, 0}, {9, 0}, {9, 1}, {8, 1}}};
  plan.route = {{1, 1}, {8, 3}, {2, 5}};
  plan.start = Pose2{1.0, 1.0, 0.0};
  return plan;
}

inline Simulation simulateHall(const SimulationOptions& options) {
  const FloorPlan plan = hall();
  return {Site{makeWorld(plan, options.furniture), plan.route, plan.start}, options};
}

}  // namespace adaptive_localization
