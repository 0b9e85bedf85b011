// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/experiment_loader.hpp"
#include "sim/rasterize.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {

/// A small hall in which no two places look alike, with its map, in a folder of its own.
class ToyExperiment {
 public:
  ToyExperiment() {
    const std::string world = folder_.write("world.yaml",
                                            "outline: [[0, 0], [6, 0], [6, 4], [4, 4], [4, 3], "
                                            "[0, 3]]\n"
                                            "solids: [[[2, 1], [2.5, 1], [2.5, 1.3], [2, 1.3]]]\n"
                                            "route: [[1, 0.6], [5, 0.8], [5, 3.2], [1, 2.2]]\n"
                                            "start: [1, 0.6, 0]\n");
    saveMap(rasterize(loadFloorPlan(world), 0.05), folder_.file("map"));
  }

  static std::string cores() { return "cores: [{filter: kld, options: {max_particles: 500}}]\n"; }

  /// Writes an experiment with what is always needed, and more, and gives its path.
  std::string write(const std::string& more) const {
    return folder_.write("toy.yaml", "name: toy\nsentence: A toy.\nworld: .\n" + more);
  }

  Experiment load(const std::string& more, const Overrides& overrides = {}) const {
    return loadExperiment(write(cores() + more), overrides);
  }

  const TempFolder& folder() const { return folder_; }

 private:
  TempFolder folder_;
};

}  // namespace adaptive_localization
