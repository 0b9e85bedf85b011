// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "eval/map_score.hpp"
#include "eval/sonar_drive.hpp"
#include "map/evidence_grid.hpp"

namespace adaptive_localization {

/// A map that a model made of a drive.
struct SonarMap {
  std::string model;
  std::shared_ptr<const EvidenceGrid> grid;
  std::optional<MapScore> score;  // where the truth is known
};

/// The true map of a world: itself, or its floor plan drawn with such cells, m.
/// Throws std::invalid_argument naming the file and what is wrong with it.
OccupancyGrid trueMapOf(const std::string& world, double resolution);

/// The lattice with cells of a size, m, that covers another one, turned as that is.
Lattice coveringLattice(const Lattice& lattice, double resolution);

/// A lattice, not turned, around all that sonars may have reached on a drive of one reading or
/// more.
Lattice latticeAround(const SonarDrive& drive, const EvidenceOptions& options, double resolution);

/// Lets a model make a map of a drive, and compares it with the true surfaces if they are given, on
/// the same lattice. Calls `progress` with the readings that are done.
SonarMap makeSonarMap(const std::string& model, const EvidenceOptions& options,
                      const SonarDrive& drive, const Lattice& lattice,
                      const std::optional<OccupancyGrid>& surfaces,
                      const std::function<void(std::size_t)>& progress = {});

/// Writes a grey picture of probabilities, black being occupied, with the rows of a map file.
/// Throws std::runtime_error naming the file that could not be written.
void saveProbabilities(const EvidenceGrid& grid, const std::string& file);

/// One row per map that has a score, for people.
std::string toTable(const std::vector<SonarMap>& maps);

nlohmann::json toJson(const std::vector<SonarMap>& maps);

}  // namespace adaptive_localization
