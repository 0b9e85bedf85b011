// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectory.hpp"

#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return al::tryFile(data, size, "poses.tum", [](const auto& file) {
    std::vector<std::string> warnings;
    al::loadTum(file, warnings);
  });
}
