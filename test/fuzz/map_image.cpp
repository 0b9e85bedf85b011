// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/map_io.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string yaml =
      al::inputFolder().write("image.yaml",
                              "image: image.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: "
                              "0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  return al::tryFile(data, size, "image.pgm", [](const auto&) { al::loadMap(yaml); });
}
