// SPDX-License-Identifier: BSD-3-Clause
#include "eval/sonar_map.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "adaptive_localization/map/map_io.hpp"
#include "core/whole_file.hpp"
#include "map/evidence_models.hpp"
#include "sim/rasterize.hpp"

namespace adaptive_localization {

OccupancyGrid trueMapOf(const std::string& world, double resolution) {
  bool is_map = false;
  try {
    const YAML::Node root = YAML::LoadFile(world);
    is_map = root.IsMap() && root["image"];
  } catch (const std::exception& error) {
    throw std::invalid_argument("world file '" + world + "': " + error.what());
  }
  return is_map ? loadMap(world) : rasterize(loadFloorPlan(world), resolution);
}

Lattice coveringLattice(const Lattice& lattice, double resolution) {
  const auto count = [&](int cells) {
    return static_cast<int>(std::ceil(cells * lattice.resolution() / resolution - 1e-6));
  };
  return Lattice(count(lattice.width()), count(lattice.height()), resolution, lattice.origin());
}

Lattice latticeAround(const SonarDrive& drive, const EvidenceOptions& options, double resolution) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const PlacedReading& one : drive.readings) {
    const Pose2 sonar = one.T_map_base * one.reading.T_base_sonar;
    const double reach = std::min(options.evidence_reach, one.reading.max_range);
    low = low.cwiseMin(Eigen::Vector2d(sonar.x - reach, sonar.y - reach));
    high = high.cwiseMax(Eigen::Vector2d(sonar.x + reach, sonar.y + reach));
  }
  const auto count = [&](double metres) {
    constexpr double kMost = 1e4;
    if (!(metres / resolution < kMost)) {
      throw std::invalid_argument("the drive spans " + std::to_string(metres) +
                                  " m, expected at most 10000 cells");
    }
    return static_cast<int>(std::ceil(metres / resolution));
  };
  const Eigen::Vector2d corner = resolution * (low / resolution).array().floor();
  return Lattice(count(high.x() - corner.x()), count(high.y() - corner.y()), resolution,
                 {corner.x(), corner.y(), 0.0});
}

SonarMap makeSonarMap(const std::string& model, const EvidenceOptions& options,
                      const SonarDrive& drive, const Lattice& lattice,
                      const std::optional<OccupancyGrid>& surfaces,
                      const std::function<void(std::size_t)>& progress) {
  std::shared_ptr<EvidenceGrid> grid = makeEvidenceGrid(model, lattice, options);
  for (std::size_t i = 0; i < drive.readings.size(); ++i) {
    grid->add(drive.readings[i].T_map_base, drive.readings[i].reading);
    if (progress) progress(i + 1);
  }
  if (!surfaces) return {model, grid, std::nullopt};
  return {model, grid, scoreOf(*grid, *surfaces)};
}

void saveProbabilities(const EvidenceGrid& grid, const std::string& file) {
  const Lattice& lattice = grid.lattice();
  std::ostringstream output;
  output << "P5\n" << lattice.width() << ' ' << lattice.height() << "\n255\n";
  for (int y = lattice.height() - 1; y >= 0; --y) {
    for (int x = 0; x < lattice.width(); ++x) {
      output.put(static_cast<char>(std::lround(255.0 * (1.0 - grid.probability({x, y})))));
    }
  }
  writeWholeFile(file, output.str());
}

std::string toTable(const std::vector<SonarMap>& maps) {
  std::string table = "model          entropy  known  correct  precision  recall  F-score\n";
  for (const SonarMap& map : maps) {
    if (!map.score) continue;
    const MapScore& score = *map.score;
    char row[128];
    std::snprintf(row, sizeof row, "%-13s  %7.3f  %4.1f%%   %4.1f%%      %5.3f   %5.3f    %5.3f\n",
                  map.model.c_str(), score.entropy, 100.0 * score.known_share,
                  100.0 * score.correct_share, score.precision, score.recall, score.f_score);
    table += row;
  }
  return table;
}

nlohmann::json toJson(const std::vector<SonarMap>& maps) {
  nlohmann::json rows = nlohmann::json::array();
  for (const SonarMap& map : maps) {
    nlohmann::json row{{"model", map.model}};
    if (map.score) {
      row["cells"] = map.score->cells;
      row["entropy_bits"] = map.score->entropy;
      row["known_share"] = map.score->known_share;
      row["correct_share"] = map.score->correct_share;
      row["precision"] = map.score->precision;
      row["recall"] = map.score->recall;
      row["f_score"] = map.score->f_score;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace adaptive_localization
