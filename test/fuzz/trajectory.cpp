// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectory.hpp"

#include <sstream>

#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return al::tryFile(data, size, "poses.tum", [](const auto& file) {
    std::vector<std::string> warnings;
    const al::Trajectory poses = al::loadTum(file, warnings);
    const double first = poses.poses().front().stamp, last = poses.poses().back().stamp;
    for (const double share : {-0.1, 0.0, 0.3, 1.0}) poses.at(first + share * (last - first), 10.0);
    al::saveTum(poses.poses(), file);
    al::readAgain([&] { al::loadTum(file, warnings); });
  });
}
