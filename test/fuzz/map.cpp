// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/map_io.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string image = al::inputFolder().write("map.pgm", "P5\n4 3\n255\n............");
  static const std::string saved = al::inputFolder().file("saved");
  return al::tryFile(data, size, "map.yaml", [](const auto& file) {
    al::saveMap(al::loadMap(file), saved);
    al::readAgain([] { al::loadMap(saved + ".yaml"); });
  });
}
