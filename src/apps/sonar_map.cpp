// SPDX-License-Identifier: BSD-3-Clause
// Experiment E19: makes maps of what sonars heard, and compares them with the truth.
#include "eval/sonar_map.hpp"

#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/log_reader.hpp"
#include "eval/outputs.hpp"
#include "eval/program.hpp"
#include "eval/progress_bar.hpp"
#include "eval/report.hpp"
#include "eval/sonar_map_command.hpp"
#include "eval/sonar_profiles.hpp"

namespace adaptive_localization {
namespace {

std::optional<OccupancyGrid> surfacesFor(const SonarMapCommand& command) {
  if (command.truth.empty() && command.world.empty()) return std::nullopt;
  const OccupancyGrid truth =
      command.truth.empty() ? trueMapOf(command.world, command.resolution) : loadMap(command.truth);
  return surfacesOn(coveringLattice(truth.lattice(), command.resolution), truth);
}

SonarDrive readDrive(const SonarMapCommand& command) {
  Log log = readLog(command.log);
  if (!command.poses_file.empty()) setReference(loadTum(command.poses_file, log.warnings), log);
  for (const auto& warning : log.warnings) std::cerr << "sonar_map: warning: " << warning << '\n';
  try {
    return driveOf(log, command.poses);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("log '" + command.log.file + "': " + error.what());
  }
}

SonarDrive simulate(const SonarMapCommand& command) {
  ProgressBar bar(static_cast<std::size_t>(10.0 * command.seconds), !command.is_quiet,
                  "tenths of a second driven");
  return driveSonars(command.simulation, command.seconds, command.poses,
                     [&bar](std::size_t done) { bar.show(done); });
}

std::vector<SonarMap> makeMaps(const SonarMapCommand& command, const SonarDrive& drive,
                               const std::optional<OccupancyGrid>& surfaces) {
  const Lattice lattice =
      surfaces ? surfaces->lattice() : latticeAround(drive, command.evidence, command.resolution);
  const std::size_t readings = drive.readings.size();
  ProgressBar bar(readings * command.models.size(), !command.is_quiet, "readings");
  std::vector<SonarMap> maps;
  for (const std::string& model : command.models) {
    const std::size_t before = readings * maps.size();
    maps.push_back(makeSonarMap(model, command.evidence, drive, lattice, surfaces,
                                [&](std::size_t done) { bar.show(before + done); }));
  }
  return maps;
}

/// What scripts/draw draws, and a map for each model.
void write(const std::string& folder, const std::vector<SonarMap>& maps,
           const std::optional<OccupancyGrid>& surfaces, const SonarDrive& drive) {
  for (const SonarMap& map : maps) {
    const std::filesystem::path place = std::filesystem::path(folder) / map.model;
    std::filesystem::create_directories(place);
    saveMap(map.grid->toOccupancyGrid(), (place / "map").string());
    saveProbabilities(*map.grid, (place / "probability.pgm").string());
  }
  const std::filesystem::path place(folder);
  if (surfaces) saveMap(*surfaces, (place / "truth").string());
  nlohmann::json path = nlohmann::json::array();
  for (const Pose2& pose : drive.path) path.push_back({pose.x, pose.y});
  saveJson({{"kind", "sonar_maps"},
            {"maps", toJson(maps)},
            {"path", path},
            {"has_truth", surfaces.has_value()}},
           (place / "maps.json").string());
}

void run(const SonarMapCommand& command) {
  std::vector<std::string> outputs{command.json_file, command.profile_file};
  if (!command.out_folder.empty()) {
    for (const std::string& file : filesToSave(command.out_folder + "/truth"))
      outputs.push_back(file);
  }
  checkOutputs(outputs, {command.world, command.truth, command.log.file, command.poses_file});
  if (!command.profile_file.empty()) {
    SonarReading sonar;
    sonar.max_range = command.simulation.sonars.sonar_max_range;
    sonar.view = command.simulation.sonars.sonar_view;
    saveJson(sonarProfiles(command.models, command.evidence, sonar, command.resolution),
             command.profile_file);
  }
  const bool is_bag = !command.log.file.empty();
  if (command.world.empty() && !is_bag) return;
  const std::optional<OccupancyGrid> surfaces = surfacesFor(command);
  const SonarDrive drive = is_bag ? readDrive(command) : simulate(command);
  const std::vector<SonarMap> maps = makeMaps(command, drive, surfaces);
  if (!command.out_folder.empty()) write(command.out_folder, maps, surfaces, drive);
  if (!command.json_file.empty()) saveJson(toJson(maps), command.json_file);
  if (command.is_quiet) return;
  std::cout << drive.readings.size() << " readings\n";
  if (surfaces) std::cout << maps.front().score->cells << " cells count\n" << toTable(maps);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("sonar_map", al::sonarMapUsage(), al::parseSonarMapCommand, al::run,
                        {argv + 1, argv + argc});
}
