// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_loader.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string plan = al::inputFolder().write(
      "world.yaml", "outline: [[0, 0], [4, 0], [4, 3], [0, 3]]\nroute: [[1, 1], [3, 2]]\n");
  return al::tryFile(data, size, "experiment.yaml",
                     [](const auto& file) { al::loadExperiment(file); });
}
