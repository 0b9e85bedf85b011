// SPDX-License-Identifier: BSD-3-Clause
// A file of experiments, in a folder with a world and its map.
#include "eval/experiment_loader.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string files[] = {
      al::inputFolder().write(
          "world.yaml", "outline: [[0, 0], [4, 0], [4, 3], [0, 3]]\nroute: [[1, 1], [3, 2]]\n"),
      al::inputFolder().write("map.yaml", "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\n"),
      al::inputFolder().write("map.pgm", "P5\n4 3\n255\n............")};
  static const al::Overrides overrides{
      {"duration", "20"}, {"simulation.people", "3"}, {"max_particles", "100"}};
  return al::tryFile(data, size, "experiment.yaml",
                     [](const auto& file) { al::loadExperiment(file, overrides); });
}
