// SPDX-License-Identifier: BSD-3-Clause
#include "ser/places.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

#include "map/ray_caster.hpp"
#include "measure.hpp"
#include "plain_energies.hpp"
#include "sim/free_space.hpp"
#include "sim/rasterize.hpp"
#include "toy_building.hpp"

namespace adaptive_localization {
namespace {

using Map = std::shared_ptr<const OccupancyGrid>;

FloorPlan planOf(const std::string& world) {
  return loadFloorPlan(SOURCE_DIR "/maps/" + world + "/world.yaml");
}
Map mapOf(const std::string& world, double resolution) {
  if (world == "building") return toyBuilding(1000);
  return std::make_shared<const OccupancyGrid>(rasterize(planOf(world), resolution));
}

ScanGeometry halfCircle() {
  ScanGeometry geometry;
  geometry.max_range = 10.0;
  geometry.first = -45;
  geometry.count = 91;
  return geometry;
}

/// 181 beams of half a circle with 31 mm of noise, one in twenty wrong.
LaserScan scanOf(const World& world, const Pose2& pose, Rng& rng) {
  LaserScan message;
  message.angle_min = -kPi / 2;
  message.angle_increment = kPi / 180;
  message.range_max = 30.0;
  for (int i = 0; i <= 180; ++i) {
    const double theta = pose.theta + message.angle_min + i * message.angle_increment;
    const double range =
        rng.uniform() < 0.05 ? rng.uniform(0.1, 10.0) : world.range({pose.x, pose.y, theta}, 30.0);
    message.ranges.push_back(static_cast<float>(range + rng.normal(0.0, 0.031)));
  }
  return message;
}

/// What every start on this map needs: ranges and blocks of the search; one thread.
void ranges(benchmark::State& state, const std::string& world, double resolution) {
  const Map map = mapOf(world, resolution);
  std::size_t cells = 0, bytes = 0;
  for (auto _ : state) {
    const EnergyGrid grid(*map, halfCircle(), {});  // which nobody asks for energies
    cells = grid.ranges().size();
    bytes = grid.ranges().bytes();
  }
  countItems(state, static_cast<std::int64_t>(cells));
  state.counters["bytes_per_cell"] = static_cast<double>(bytes) / static_cast<double>(cells);
}

/// The same, and sorted energies, as a region of similar ones asks for.
void energyGrid(benchmark::State& state, const std::string& world, double resolution) {
  const Map map = mapOf(world, resolution);
  std::size_t cells = 0, bytes = 0;
  for (auto _ : state) {
    const EnergyGrid grid(*map, halfCircle(), {});
    benchmark::DoNotOptimize(grid.similarTo({0.5, 0.02}));
    cells = grid.ranges().size();
    bytes = grid.bytes();
  }
  countItems(state, static_cast<std::int64_t>(cells));
  state.counters["bytes_per_cell"] = static_cast<double>(bytes) / static_cast<double>(cells);
}

void plainGrid(benchmark::State& state, const std::string& world, double resolution) {
  const Map map = mapOf(world, resolution);
  for (auto _ : state) benchmark::DoNotOptimize(plainEnergies(*map, 18, 30, 10.0));
  countItems(state, static_cast<std::int64_t>(map->countFree()));
}

/// The same from cache_dir, its files being in the system's memory.
void readGrid(benchmark::State& state, const std::string& world, double resolution) {
  const Map map = mapOf(world, resolution);
  const auto field = std::make_shared<const DistanceField>(*map);
  std::string folder = (std::filesystem::temp_directory_path() / "al_bench_XXXXXX").string();
  if (!mkdtemp(folder.data())) state.SkipWithError("no folder for files");
  EnergyGridOptions options;
  options.cache_dir = folder;
  Rng rng(1);
  const Scan scan = toScan(scanOf(*makeWorld(map), kTruth, rng), LaserMount{}, ScanOptions{});
  std::size_t cells = 0;
  const auto isRead = [&] {
    Places places(map, field, options, {});
    cells = places.energyGrid(scan)->ranges().size();
    return places.isNewestFromCache();
  };
  isRead();
  bool was_read = true;
  for (auto _ : state) was_read &= isRead();
  if (!was_read) state.SkipWithError("the grid was not kept");
  countItems(state, static_cast<std::int64_t>(cells));
  std::filesystem::remove_all(folder);
}

/// Searches for scans taken all over the world, on its true surfaces. An item is a pose.
void globalSearch(benchmark::State& state, const std::string& name) {
  const Map map = mapOf(name, 0.05);
  const auto world = name == "building" ? makeWorld(map) : makeWorld(planOf(name), false);
  const FreeSpace free_space(world, 0.2);
  const auto grid = std::make_shared<const EnergyGrid>(*map, halfCircle(), EnergyGridOptions{});
  const auto search = std::make_shared<const GlobalSearch>(
      grid, map, std::make_shared<const DistanceField>(*map), GlobalSearchOptions{});
  Rng rng(1);
  std::vector<Scan> scans;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d place = free_space.sample(rng);
    const Pose2 pose{place.x(), place.y(), rng.uniform(-kPi, kPi)};
    scans.push_back(toScan(scanOf(*world, pose, rng), LaserMount{}, ScanOptions{}));
  }
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(findPlaces(search, scans[next++ % scans.size()]));
  }
  double visited = 0.0;
  for (const Scan& scan : scans) {
    search->findPoses(toDirections(scan, grid->geometry()));
    visited += search->visitedShare();
  }
  countItems(state, static_cast<std::int64_t>(grid->ranges().size() * kDirections));
  state.counters["visited"] = visited / static_cast<double>(scans.size());
}

}  // namespace

void registerPlaces() {
  const auto add = [](const std::string& name, auto&& run, const std::string& world,
                      double resolution) {
    benchmark::RegisterBenchmark(name.c_str(), run, world, resolution)
        ->Unit(benchmark::kMillisecond);
  };
  for (const int centimetres : {5, 10, 15, 20, 25}) {
    const std::string suffix = std::to_string(centimetres);
    add("energy_grid/plain/" + suffix, plainGrid, "maze", 0.01 * centimetres);
    add("energy_grid/" + suffix, energyGrid, "maze", 0.01 * centimetres);
    add("range_table/" + suffix, ranges, "maze", 0.01 * centimetres);
  }
  add("energy_grid/building", energyGrid, "building", 0.05);
  add("range_table/building", ranges, "building", 0.05);
  add("range_table/building/read", readGrid, "building", 0.05);
  for (const std::string world : {"maze", "expansion", "symmetric", "building"}) {
    benchmark::RegisterBenchmark(("global_search/" + world).c_str(), globalSearch, world)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace adaptive_localization
