// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_site.hpp"

#include "adaptive_localization/map/map_io.hpp"
#include "sim/rasterize.hpp"

namespace adaptive_localization {

ExperimentSite loadSite(const ExperimentCase& of_case) {
  constexpr double kSurveyCell = 0.05;  // m
  constexpr double kSurveyTurn = 0.1;   // rad: nobody aligns a map with the walls
  constexpr double kMargin = 0.01;      // m, as the simulation has it
  const SimulationOptions options = SimulationOptions::from(of_case.simulation);
  ExperimentSite site;
  site.site = loadSite(of_case.world, options.furniture);
  site.free_space =
      std::make_shared<const FreeSpace>(site.site.world, options.base.robot_radius + kMargin);
  site.ground = std::make_shared<const OccupancyGrid>(
      of_case.map.empty() ? rasterize(loadFloorPlan(of_case.world), kSurveyCell, kSurveyTurn)
                          : loadMap(of_case.map));
  return site;
}

}  // namespace adaptive_localization
