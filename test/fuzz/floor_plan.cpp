// SPDX-License-Identifier: BSD-3-Clause
#include "map/floor_plan.hpp"

#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return al::tryFile(data, size, "plan.yaml",
                     [](const auto& file) { al::surfacesOf(al::loadFloorPlan(file)); });
}
