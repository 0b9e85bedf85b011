// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/input_file.hpp"
#include "map/landmark_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return al::tryFile(data, size, "landmarks.yaml",
                     [](const auto& file) { al::loadLandmarks(file); });
}
