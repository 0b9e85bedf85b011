// SPDX-License-Identifier: BSD-3-Clause
// Builds, inspects and draws the energy grid of a map.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/energy_command.hpp"
#include "eval/outputs.hpp"
#include "eval/program.hpp"
#include "eval/progress_bar.hpp"
#include "eval/report.hpp"
#include "eval/stopwatch.hpp"
#include "map/ray_caster.hpp"
#include "ser/place_search.hpp"

namespace adaptive_localization {
namespace {

/// A scan of one beam per degree, taken at a pose, or with nothing but its geometry.
Scan simulate(const EnergyCommand& command, const std::shared_ptr<const OccupancyGrid>& map,
              double max_range) {
  const bool all_round = command.view > 359.0;
  const int steps = std::max(1, static_cast<int>(std::lround(command.view)));
  LaserScan scan;
  scan.angle_min = -0.5 * command.view * kPi / 180.0;
  scan.angle_increment = command.view * kPi / 180.0 / steps;
  scan.range_max = max_range;
  scan.ranges.assign(static_cast<std::size_t>(steps + (all_round ? 0 : 1)),
                     std::numeric_limits<float>::quiet_NaN());
  const RayCaster caster(map);
  for (std::size_t i = 0; command.query && i < scan.ranges.size(); ++i) {
    const double bearing = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const double range = caster.range(*command.query * Pose2{0.0, 0.0, bearing}, max_range);
    scan.ranges[i] =
        range < max_range ? static_cast<float>(range) : std::numeric_limits<float>::infinity();
  }
  ScanOptions all_beams;
  all_beams.laser_max_beams = 1000;
  return toScan(scan, LaserMount{}, all_beams);
}

/// Sorted, too.
std::shared_ptr<const EnergyGrid> build(const OccupancyGrid& map, const ScanGeometry& geometry,
                                        const EnergyGridOptions& options) {
  ProgressBar bar(kDirections, true, "directions");
  auto grid = std::make_shared<const EnergyGrid>(map, geometry, options,
                                                 [&bar](std::size_t done) { bar.show(done); });
  grid->energy(0);  // who asks first has it sorted
  return grid;
}

void printHistogram(const EnergyGrid& grid) {
  constexpr int kBins = 20;
  constexpr std::size_t kWidth = 50;
  std::array<std::size_t, kBins> counts{};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const int bin = static_cast<int>(grid.energy(i) * kBins);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))];
  }
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  std::printf("energy           poses\n");
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    if (counts[bin] == 0) continue;
    std::printf("%.2f to %.2f %9zu %s\n", static_cast<double>(bin) / kBins,
                static_cast<double>(bin + 1) / kBins, counts[bin],
                std::string(kWidth * counts[bin] / most, '#').c_str());
  }
}

void printPlaces(const std::shared_ptr<const EnergyGrid>& grid,
                 const std::shared_ptr<const OccupancyGrid>& map, const Scan& scan) {
  const auto field = std::make_shared<const DistanceField>(*map);
  const auto search = std::make_shared<const GlobalSearch>(grid, map, field, GlobalSearchOptions{});
  const Stopwatch stopwatch;
  const std::vector<Place> places = findPlaces(search, scan);
  const double seconds = stopwatch.seconds();
  search->findPoses(toDirections(scan, grid->geometry()));
  std::printf("search: %zu %s in %.4f s, %.2f %% of poses visited\n", places.size(),
              places.size() == 1 ? "place" : "places", seconds, 100.0 * search->visitedShare());
  for (const auto& place : places) {
    std::printf("  x %.3f m, y %.3f m, yaw %.1f deg: mean error %.3f m\n", place.T_map_base.x,
                place.T_map_base.y, place.T_map_base.theta * 180.0 / kPi, place.error);
  }
}

/// For scripts/draw: x, y, mean energy over the headings and share of them in a region, of each
/// cell.
nlohmann::json toJson(const EnergyCommand& command, const EnergyGrid& grid,
                      const EnergyGrid::Region& region) {
  struct Sums {
    double energy{0.0};
    std::size_t count{0}, in_region{0};
  };
  std::map<std::pair<double, double>, Sums> sums;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Pose2 pose = grid.pose(i);
    Sums& cell = sums[{pose.x, pose.y}];
    cell.energy += grid.energy(i);
    ++cell.count;
    cell.in_region += i >= region.begin && i < region.end ? 1U : 0U;
  }
  nlohmann::json cells = nlohmann::json::array(), query;
  for (const auto& [place, cell] : sums) {
    const auto count = static_cast<double>(cell.count);
    cells.push_back({place.first, place.second, cell.energy / count,
                     static_cast<double>(cell.in_region) / count});
  }
  if (command.query) query = {command.query->x, command.query->y, command.query->theta};
  const Lattice& lattice = grid.ranges().lattice();
  return {{"kind", "energies"},
          {"map", std::filesystem::absolute(command.map).string()},
          {"cell_size", grid.ranges().spacing() * lattice.resolution()},
          {"headings", grid.orientations()},
          {"query", query},
          {"cells", cells}};
}

void run(const EnergyCommand& command) {
  checkOutputs({command.json_file}, filesOfMap(command.map));
  const auto map = std::make_shared<const OccupancyGrid>(loadMap(command.map));
  if (command.query && !map->isFree(map->lattice().cellAt({command.query->x, command.query->y}))) {
    throw std::invalid_argument("--query: that is not on free ground of " + command.map);
  }
  const auto options = command.options.read<EnergyGridOptions>();
  const Scan scan = simulate(command, map, options.energy_max_range);
  const Stopwatch stopwatch;
  const auto grid = build(*map, geometryOf(scan, options.energy_max_range), options);
  const double seconds = stopwatch.seconds();
  std::printf("map: %d x %d cells of %.3f m, %zu of them free\n", map->lattice().width(),
              map->lattice().height(), map->lattice().resolution(), map->countFree());
  std::printf("grid: %zu cells x %d headings = %zu poses, %.1f MB, built in %.4f s\n",
              grid->ranges().size(), grid->orientations(), grid->size(),
              1e-6 * static_cast<double>(grid->bytes()), seconds);
  printHistogram(*grid);
  EnergyGrid::Region region{};
  if (command.query) {
    const auto energy = grid->energyOf(scan);
    if (!energy) throw std::invalid_argument("--query: no beam of the scan is valid there");
    region = grid->similarTo(*energy);
    std::printf("scan: energy %.4f; region: %zu poses within %.3f, %.2f %% of all\n", energy->value,
                region.size(), energy->delta,
                100.0 * static_cast<double>(region.size()) / static_cast<double>(grid->size()));
    printPlaces(grid, map, scan);
  }
  if (!command.json_file.empty()) saveJson(toJson(command, *grid, region), command.json_file);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("energy_grid", al::energyUsage(), al::parseEnergyCommand, al::run,
                        {argv + 1, argv + argc});
}
